/// The circulation of a field around triangles: zero if waves along it are the gradient of a phase.
#pragma once

#include <array>

#include <Eigen/Core>

namespace brindle {

/// Triangles processed together.
inline constexpr int kTriangleLanes = 8;

using Lanes = Eigen::Array<float, kTriangleLanes, 1>;
using LaneVectors = std::array<Lanes, 3>;  ///< x, y and z

/// Shapes of triangles, one per lane.
struct TriangleShapes {
  std::array<LaneVectors, 3> edge;      ///< opposite to each corner, counter-clockwise
  std::array<Lanes, 3> half_cotangent;  ///< of the angle at each corner
  LaneVectors normal;                   ///< of length 1, or nearly zero
  Lanes area;
};

/// Slivers get the area, and so the cotangents, of less thin triangles; otherwise one of them could
/// outweigh all others.
TriangleShapes triangle_shapes(const std::array<LaneVectors, 3>& corners);

/// The circulation around a triangle of g d, with a frequency g per corner, is `sum_m c_m g_m`: c_m
/// is half of <e, d_m>, summed over the two edges at m. Corners are oriented alike; zero if they
/// cannot be. Directions are projected into the triangle's plane and normalised there.
std::array<Lanes, 3> circulation_coefficients(const TriangleShapes& shapes,
                                              const std::array<LaneVectors, 3>& directions);

/// A safe divisor: zero becomes 1.
Lanes divisor(const Lanes& x);

/// The square root of IEEE 754. Eigen's vector code approximates it, differently on each processor.
Lanes square_root(const Lanes& x);

}  // namespace brindle
