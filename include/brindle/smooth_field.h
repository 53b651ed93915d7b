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

/// Directions that are known of a field, more or less.
struct KnownDirections {
  DirectionField directions;  ///< one per vertex, of any length; their tangent part counts. Zero:
                              ///< nothing is known there. Empty: nowhere
  std::vector<float> confidence;  ///< how much each counts: 0 or above, one per vertex; empty: 1
  float weight = 0.01f;           ///< how strongly they attract the field, in multiples of what all
                                  ///< neighbours of a vertex pull together, times the confidence
};

struct SmoothFieldOptions {
  int symmetry = 2;            ///< N: 1 vector, 2 line, 4 cross field
  float curvature_anchor = 0;  ///< how strongly principal curvature attracts the field; 0: not
  CurvatureDirection curvature_direction = CurvatureDirection::maximum;
  float feature_anchor = 0;  ///< how strongly sharp edges and boundaries attract the field, so that
                             ///< one of its directions runs along them; 0: not
  float feature_angle_deg = 40;  ///< an edge is sharp if the surface bends there by more than this
  float feature_radius = 0;      ///< how far from them features attract, as strokes of this radius
                                 ///< (`feature_strokes`), in units of length; 0: at their vertices
  float normal_radius = 0;  ///< the field follows the bends of a surface whose normals are averaged
                            ///< over so large a distance, in units of length: what is smaller makes
                            ///< no singularities; 0: as they are
  std::vector<FieldAnchor> anchors = {};  ///< such as `stroke_anchors`; they have a sign only where
                                          ///< the symmetry is odd
  /// The field before, as `carried_field.h` gives it on this surface. The new one goes on from it:
  /// it starts there, is drawn to it, and keeps its signs and, of crosses, which of their
  /// directions it names. So it turns as little as the surface asks for, where a field that is
  /// found anew may turn as a whole.
  KnownDirections last = {};
  int sweeps = 4;  ///< coloured sweeps per level
  int cycles = 2;  ///< further descents, which remove pairs of singularities
};

/// A direction field that turns as little as possible from vertex to vertex: each direction's angle
/// theta in its tangent basis enters as u = exp(i N theta), coupled by parallel transport.
/// Directions are signed to run like their neighbours where that is possible, and like the last
/// field's where there is one. Throws Error for options out of range, among them feature anchors
/// with an odd symmetry (an edge has no sign), for anchors as SmoothFieldAnimator::frame does, for
/// known directions that are not one per vertex or not finite, and for positions and normals that
/// are not finite; Cancelled if `progress` asks for it.
DirectionField smooth_direction_field(const Surface& surface,
                                      const SmoothFieldOptions& options = {},
                                      const Progress& progress = {});

struct SmoothFieldAnimatorOptions {
  int symmetry = 2;      ///< N: 1 vector, 2 line, 4 cross field
  float lambda = 0.05f;  ///< weight of the anchors to the last frame's field; 0: from scratch
  int sweeps = 2;        ///< coloured sweeps per level
};

/// Solves for a smooth field on one surface whose anchors (data, curvature, a user's brush strokes)
/// change. Connectivity and transport are handled once; a frame costs a few milliseconds.
class SmoothFieldAnimator {
 public:
  /// Throws Error for options out of range, and for normals that are not finite; Cancelled if
  /// `progress`, which hears of the topology, asks for it.
  explicit SmoothFieldAnimator(const Surface& surface,
                               const SmoothFieldAnimatorOptions& options = {},
                               const Progress& progress = {});
  ~SmoothFieldAnimator();
  SmoothFieldAnimator(SmoothFieldAnimator&&) noexcept;
  SmoothFieldAnimator& operator=(SmoothFieldAnimator&&) noexcept;

  /// The field for these anchors, one unit tangent vector per vertex, signed to run like its
  /// neighbours in the first frame and like the last frame's after that; valid until the next
  /// frame. An unchanged list of anchors gives the unchanged field. `progress` hears of what is
  /// solved. Throws Error for a vertex out of range, and for a direction or weight that is not
  /// finite; Cancelled if `progress` asks for it. The animator then is as it was before the call.
  std::span<const Vec3> frame(std::span<const FieldAnchor> anchors, const Progress& progress = {});

 private:
  struct State;
  void set_anchors(std::span<const FieldAnchor> anchors);
  Pimpl<State> state_;
};

}  // namespace brindle
