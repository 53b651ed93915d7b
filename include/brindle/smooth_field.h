/// Smooth direction fields by the multilevel phase solver (docs/method.md).
#pragma once

#include <span>
#include <vector>

#include "brindle/direction_field.h"
#include "brindle/export.h"
#include "brindle/progress.h"
#include "brindle/strokes.h"
#include "brindle/surface.h"

namespace BRINDLE_EXPORT brindle {

/// Known directions of a field, with their confidence.
struct KnownDirections {
  DirectionField directions;      ///< one per vertex, of any length; the tangent part counts. Zero:
                                  ///< unknown there. Empty: unknown everywhere
  std::vector<float> confidence;  ///< 0 or above, one per vertex; empty: 1
  float weight = 0.01f;  ///< strength of attraction, in multiples of the pull of all neighbours of
                         ///< a vertex, times the confidence
};

/// Options of `smooth_direction_field`.
struct SmoothFieldOptions {
  int symmetry = 2;            ///< N: 1 vector, 2 line, 4 cross field
  float curvature_anchor = 0;  ///< attraction to principal curvature; 0: none
  CurvatureDirection curvature_direction = CurvatureDirection::maximum;
  /// Attraction of one of the field's directions to sharp edges and boundaries; 0: none.
  float feature_anchor = 0;
  float feature_angle_deg = 40;  ///< sharp edges bend by more than this
  float feature_radius = 0;  ///< reach of features, as strokes of this radius (`feature_strokes`),
                             ///< in units of length; 0: only at their vertices
  float normal_radius = 0;   ///< normals are averaged over this distance, in units of length, so
                             ///< that smaller detail makes no singularities; 0: off
  /// Such as `stroke_anchors`; signs count only for odd symmetry.
  std::vector<FieldAnchor> anchors = {};
  /// The previous field on this surface, from `carried_phases.h`. The new one starts there, is
  /// attracted to it, and keeps its signs and, for crosses, its choice of direction. It thus turns
  /// only as much as the surface requires; an independent field may turn as a whole.
  KnownDirections last = {};
  int sweeps = 4;  ///< coloured sweeps per level
  int cycles = 2;  ///< further descents, which remove pairs of singularities
};

/// A direction field that turns as little as possible from vertex to vertex. Each direction's angle
/// theta in its tangent basis enters as u = exp(i N theta), coupled by parallel transport. Signs
/// follow neighbours where possible, and the last field if there is one. Throws Error for options
/// out of range, including feature anchors with odd symmetry (an edge has no sign), for anchors as
/// SmoothFieldAnimator::frame does, for known directions that are not one per vertex or not finite,
/// and for positions and normals that are not finite; Cancelled if `progress` cancels.
DirectionField smooth_direction_field(const Surface& surface,
                                      const SmoothFieldOptions& options = {},
                                      const Progress& progress = {});

/// Options of SmoothFieldAnimator.
struct SmoothFieldAnimatorOptions {
  int symmetry = 2;      ///< N: 1 vector, 2 line, 4 cross field
  float lambda = 0.05f;  ///< weight of the anchors to the last frame's field; 0: from scratch
  int sweeps = 2;        ///< coloured sweeps per level
};

/// Solves for a smooth field on one surface with changing anchors (data, curvature, a user's brush
/// strokes). Connectivity and transport are computed once; a frame takes a few milliseconds.
class SmoothFieldAnimator {
 public:
  /// Throws Error for options out of range, and for normals that are not finite; Cancelled if
  /// `progress`, which reports the topology, cancels.
  explicit SmoothFieldAnimator(const Surface& surface,
                               const SmoothFieldAnimatorOptions& options = {},
                               const Progress& progress = {});
  ~SmoothFieldAnimator();
  SmoothFieldAnimator(SmoothFieldAnimator&&) noexcept;
  SmoothFieldAnimator& operator=(SmoothFieldAnimator&&) noexcept;

  /// The field for these anchors, one unit tangent vector per vertex, valid until the next frame.
  /// Signs follow neighbours in the first frame and the last frame after that. Unchanged anchors
  /// give an unchanged field. `progress` reports the solver. Throws Error for a vertex out of
  /// range, and for a direction or weight that is not finite; Cancelled if `progress` cancels. Then
  /// the animator is unchanged.
  std::span<const Vec3> frame(std::span<const FieldAnchor> anchors, const Progress& progress = {});

 private:
  struct State;
  void set_anchors(std::span<const FieldAnchor> anchors);
  Pimpl<State> state_;
};

}  // namespace brindle
