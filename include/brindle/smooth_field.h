/// Smooth direction fields by the multilevel phase solver (docs/method.md).
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "brindle/direction_field.h"
#include "brindle/export.h"
#include "brindle/strokes.h"
#include "brindle/surface.h"

namespace BRINDLE_EXPORT brindle {

struct SmoothFieldOptions {
  int symmetry = 2;            ///< N: 1 vector, 2 line, 4 cross field
  float curvature_anchor = 0;  ///< how strongly principal curvature attracts the field; 0: not
  CurvatureDirection curvature_direction = CurvatureDirection::maximum;
  float feature_anchor = 0;  ///< how strongly sharp edges and boundaries attract the field, so that
                             ///< one of its directions runs along them; 0: not
  float feature_angle_deg = 40;  ///< an edge is sharp if the surface bends there by more than this
  float feature_radius = 0;      ///< how far from them features attract, as strokes of this radius
                                 ///< (`feature_strokes`), in units of length; 0: at their vertices
  std::vector<FieldAnchor> anchors = {};  ///< such as `stroke_anchors`; they have a sign only where
                                          ///< the symmetry is odd
  int sweeps = 4;                         ///< coloured sweeps per level
  int cycles = 2;                         ///< further descents, which remove pairs of singularities
};

/// A direction field that turns as little as possible from vertex to vertex: each direction's angle
/// theta in its tangent basis enters as u = exp(i N theta), coupled by parallel transport.
/// Directions are signed to run like their neighbours where that is possible. Throws Error for
/// options out of range, among them feature anchors with an odd symmetry (an edge has no sign), for
/// anchors as SmoothFieldAnimator::frame does, and for positions and normals that are not finite.
DirectionField smooth_direction_field(const Surface& surface,
                                      const SmoothFieldOptions& options = {});

struct SmoothFieldAnimatorOptions {
  int symmetry = 2;      ///< N: 1 vector, 2 line, 4 cross field
  float lambda = 0.05f;  ///< weight of the anchors to the last frame's field; 0: from scratch
  int sweeps = 2;        ///< coloured sweeps per level
};

/// Solves for a smooth field on one surface whose anchors (data, curvature, a user's brush strokes)
/// change. Connectivity and transport are handled once; a frame costs a few milliseconds.
class SmoothFieldAnimator {
 public:
  /// Throws Error for options out of range, and for normals that are not finite.
  explicit SmoothFieldAnimator(const Surface& surface,
                               const SmoothFieldAnimatorOptions& options = {});
  ~SmoothFieldAnimator();
  SmoothFieldAnimator(SmoothFieldAnimator&&) noexcept;
  SmoothFieldAnimator& operator=(SmoothFieldAnimator&&) noexcept;

  /// The field for these anchors, one unit tangent vector per vertex, signed to run like its
  /// neighbours in the first frame and like the last frame's after that; valid until the next
  /// frame. An unchanged list of anchors gives the unchanged field. Throws Error for a vertex out
  /// of range, and for a direction or weight that is not finite; the animator then is as it was
  /// before the call.
  std::span<const Vec3> frame(std::span<const FieldAnchor> anchors);

 private:
  struct State;
  void set_anchors(std::span<const FieldAnchor> anchors);
  std::unique_ptr<State> state_;
};

}  // namespace brindle
