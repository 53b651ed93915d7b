/// Where segments of curves run on a mesh.
#pragma once

#include <array>

#include "brindle/mesh.h"
#include "brindle/pattern/lifted_waves.h"
#include "brindle/polylines.h"

namespace brindle {

/// A point on an edge or inside of a triangle, told by the vertices around it.
struct MeshPoint {
  std::array<Index, 3> vertices{};
  std::array<double, 3> weights{};   ///< not negative, sum to 1
  std::array<Index, 2> triangles{};  ///< that it is in; twice the same if there is only one
};

/// A point of a curve.
struct CurvePoint {
  Vec3 position;
  Vec3 normal;
  Vec3 forward;  ///< where the wave there runs; zero in the middle of a triangle
  float size;    ///< of the edge that it lies on, or of the triangle
  MeshPoint place;
};

CurvePoint point_in_triangle(const WavePattern& pattern, const TrianglePoint& place);

/// Adds part of a point's normal. Normals of unorientable surfaces may point either way.
void add_normal(const WavePattern& pattern, float weight, Index vertex, Vec3& sum);

/// The ends of a segment in one triangle.
struct PlacedSegment {
  Index triangle = 0;
  std::array<double, 3> from{}, to{};  ///< barycentric coordinates
};

/// Of the triangles of both ends one that has both. If there is none, since points between them
/// were passed over, the one that they are nearest to; what is beside it is moved onto it.
PlacedSegment placed_segment(const Mesh& mesh, const MeshPoint& from, const MeshPoint& to);

}  // namespace brindle
