/// Positions of curve segments on a mesh.
#pragma once

#include <array>

#include "brindle/mesh.h"
#include "brindle/pattern/lifted_waves.h"
#include "brindle/polylines.h"

namespace brindle {

/// A point on an edge or inside a triangle, given by the vertices around it.
struct MeshPoint {
  std::array<Index, 3> vertices{};
  std::array<double, 3> weights{};   ///< not negative, sum to 1
  std::array<Index, 2> triangles{};  ///< that contain it; twice the same if there is only one
};

/// A point of a curve.
struct CurvePoint {
  Vec3 position;
  Vec3 normal;
  Vec3 forward;  ///< direction of the wave; zero inside a triangle
  float size;    ///< of its edge or triangle
  MeshPoint place;
};

CurvePoint point_in_triangle(const WavePattern& pattern, const TrianglePoint& place);

/// Adds a vertex normal with a weight, flipped to agree with `sum`: normals of unorientable
/// surfaces may point either way.
void add_normal(const WavePattern& pattern, float weight, Index vertex, Vec3& sum);

/// The ends of a segment in one triangle.
struct PlacedSegment {
  Index triangle = 0;
  std::array<double, 3> from{}, to{};  ///< barycentric coordinates
};

/// Places a segment in a triangle that contains both ends. If there is none, because points between
/// them were dropped, uses the triangle nearest to both and moves the ends into it.
PlacedSegment placed_segment(const Mesh& mesh, const MeshPoint& from, const MeshPoint& to);

}  // namespace brindle
