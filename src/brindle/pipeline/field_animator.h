/// A smooth direction field that follows changing anchors, frame by frame.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "brindle/base/adjacency.h"
#include "brindle/phases/hierarchy.h"
#include "brindle/waves/direction_field.h"

namespace brindle {

/// Draws the field at a vertex towards a direction.
struct FieldAnchor {
  Index vertex;
  Vec3 direction;  ///< unit tangent vector, or zero for no anchor
  float weight;    ///< 0 or above; 1 is as strong as all neighbours together
};

struct FieldAnimatorOptions {
  int symmetry = 2;      ///< N: 1 vector, 2 line, 4 cross field
  float lambda = 0.02f;  ///< weight of the anchor to the last frame's field; 0: from scratch
  int sweeps = 4;        ///< coloured sweeps per level
};

/// The field of `smooth_direction_field`, solved anew in every frame by a whole multilevel descent
/// that is drawn to the frame's anchors and to the last frame's field (DESIGN section 3, "Changing
/// input"). What depends on the connectivity and on the normals is built once.
class FieldAnimator {
 public:
  /// `normals` has one unit vector or zero per vertex. Throws Error for options out of range.
  FieldAnimator(std::shared_ptr<const Adjacency> neighborhood, std::span<const Vec3> normals,
                const FieldAnimatorOptions& options = {});

  /// The next frame's field: unit tangent vectors, of the N equal ones those that turn least from
  /// the last frame. Valid until the next call. The same anchors as in the last frame leave it as
  /// it is.
  const DirectionField& frame(std::span<const FieldAnchor> anchors);

 private:
  void renew_anchors(float lambda);
  void turn_to_solution();

  FieldAnimatorOptions options_;
  std::shared_ptr<const Adjacency> neighborhood_;
  std::vector<Vec3> normals_;
  Hierarchy hierarchy_;
  std::vector<Complex> gauged_;  // what renew_sums works in
  std::vector<FieldAnchor> anchors_;
  std::vector<float> angle_;  // of the directions in their tangent bases, radians
  DirectionField directions_;
};

}  // namespace brindle
