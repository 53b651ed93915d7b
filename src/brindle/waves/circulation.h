/// What waves that run along a field lack to be the gradient of a phase, triangle by triangle.
#pragma once

#include <array>

#include <Eigen/Core>

namespace brindle {

/// So many triangles are worked on side by side.
inline constexpr int kTriangleLanes = 8;

using Lanes = Eigen::Array<float, kTriangleLanes, 1>;
using LaneVectors = std::array<Lanes, 3>;  ///< x, y and z

struct TriangleShapes {
  std::array<LaneVectors, 3> edge;      ///< opposite to each corner, going round
  std::array<Lanes, 3> half_cotangent;  ///< of the angle at each corner
  LaneVectors normal;                   ///< of length 1, or nearly zero
  Lanes area;
};

/// Slivers have the area, and so the cotangents, of triangles not quite as thin, lest one of them
/// outweighs all others.
TriangleShapes triangle_shapes(const std::array<LaneVectors, 3>& corners);

/// The circulation around a triangle of g d, g a frequency per corner, is `sum_m c_m g_m`: c_m is
/// half of <e, d_m>, summed over the two edges at m. Corners are oriented alike and directions
/// projected into the triangle's plane, where they have length 1. Zero where the corners cannot be
/// oriented alike.
std::array<Lanes, 3> circulation_coefficients(const TriangleShapes& shapes,
                                              const std::array<LaneVectors, 3>& directions);

/// What may be divided by: zero becomes 1.
Lanes divisor(const Lanes& x);

/// Rounded as IEEE 754 has it. Eigen's own approximates, and each processor in its way.
Lanes square_root(const Lanes& x);

}  // namespace brindle
