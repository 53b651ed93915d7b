/// The circulation of a field around triangles: zero if waves along it are the gradient of a phase.
#pragma once

#include <array>
#include <span>

#include <Eigen/Core>

#include "brindle/direction_field.h"
#include "brindle/mesh.h"
#include "brindle/phase_graph.h"

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

// The rotation of a freely turning field that makes stripes along it branch least.

/// Integrals over triangles of the squared curl of a field of unit directions (up to sign), its
/// squared divergence, and their product. Divergence is the curl of the field turned by 90 degrees.
struct CurlSums {
  double curl = 0, divergence = 0, mixed = 0;

  CurlSums operator+(const CurlSums& other) const {
    return {curl + other.curl, divergence + other.divergence, mixed + other.mixed};
  }
};

/// `directions` and `normals` have one entry per vertex. Triangles whose corners cannot be oriented
/// alike do not count.
CurlSums curl_sums(const Mesh& mesh, std::span<const Vec3> directions,
                   std::span<const Vec3> normals);

/// Whether all normals of a direction graph point to one side: one angle can turn all directions.
bool is_one_sided(const PhaseGraph& graph);

/// Whether turning all directions of an N-direction field by one angle keeps its energy but changes
/// its curl: it is one-sided, without anchors, and N is 1 or 2.
bool turns_freely(const PhaseGraph& graph, int symmetry);

/// The angle, from -pi/2 to pi/2 and counter-clockwise about the normals, that minimises the
/// squared curl. With d' = cos b d + sin b (n x d): curl cos^2 b + divergence sin^2 b + 2 mixed cos
/// b sin b.
float least_curl_angle(const CurlSums& sums);

/// Whether turning by that angle more than halves a curl that stripes would show. Fields that gain
/// less are not turned, so that nearly equal surfaces have the same field.
bool is_much_curled(const CurlSums& sums);

/// Turns a smooth field with these sums to the least curl if it is much curled or `new_found`. The
/// latter is a field from a start other than that of the plain descent.
void turn_to_least_curl(const CurlSums& sums, bool new_found, std::span<const Vec3> normals,
                        DirectionField& directions);

}  // namespace brindle
