/// Soft shadows of surfaces on the ground.
#pragma once

#include <span>
#include <vector>

#include <Eigen/Geometry>

#include "brindle/mesh.h"

namespace brindle {

/// Blocked shares of light, `side` x `side`, row by row along the first axis.
struct GroundShadow {
  static constexpr int kSide = 192;
  std::vector<float> missing;
  Eigen::Vector2f lower, size;  ///< of the square, along the two ground axes
  float height = 0;             ///< of the ground, along the third axis
};

/// The columns of `axes` are two axes along the ground and the one off it. The light is vertical.
/// `points` are the corners of `triangles`.
GroundShadow ground_shadow(std::span<const Vec3> points, std::span<const Triangle> triangles,
                           const Eigen::Matrix3f& axes);

/// The part of a mesh on the negative side of the plane; triangles are clipped there.
Mesh left_by(const Eigen::Hyperplane<float, 3>& slice, const Mesh& mesh);

}  // namespace brindle
