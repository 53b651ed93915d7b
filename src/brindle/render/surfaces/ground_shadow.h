/// The soft shadow of surfaces on the ground below them.
#pragma once

#include <span>
#include <vector>

#include <Eigen/Geometry>

#include "brindle/mesh.h"

namespace brindle {

/// Shares of light that are missing, `side` x `side`, first those with the smallest second
/// coordinate.
struct GroundShadow {
  static constexpr int kSide = 192;
  std::vector<float> missing;
  Eigen::Vector2f lower, size;  ///< of the square, along the two axes of the ground
  float height = 0;             ///< of the ground, along the third axis
};

/// Coordinates are along `axes`' columns: two along the ground, one off it. All is lit from above.
/// Triangles stand for surfaces; `points` are their corners.
GroundShadow ground_shadow(std::span<const Vec3> points, std::span<const Triangle> triangles,
                           const Eigen::Matrix3f& axes);

/// The part of a mesh on the side of the plane that its normal points away from. Triangles that
/// the plane cuts end there.
Mesh left_by(const Eigen::Hyperplane<float, 3>& slice, const Mesh& mesh);

}  // namespace brindle
