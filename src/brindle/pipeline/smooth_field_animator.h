/// A smooth direction field that follows changing anchors, frame by frame: field design live.
#pragma once

#include <memory>
#include <span>

#include "brindle/geometry/surface.h"
#include "brindle/waves/direction_field.h"

namespace brindle {

struct SmoothFieldAnimatorOptions {
  int symmetry = 2;      ///< N: 1 vector, 2 line, 4 cross field
  float lambda = 0.05f;  ///< weight of the anchors to the last frame's field; 0: from scratch
  int sweeps = 2;        ///< coloured sweeps per level
};

/// Pulls the field at a vertex towards a direction.
struct FieldAnchor {
  Index vertex;
  Vec3 direction;    ///< any vector; its tangent part counts
  float weight = 1;  ///< in multiples of what all neighbours together pull
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
