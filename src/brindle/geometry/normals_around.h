/// Vertex normals from known adjacent triangles.
#pragma once

#include <array>
#include <vector>

#include "brindle/geometry/topology.h"
#include "brindle/normals.h"
#include "brindle/progress.h"

namespace brindle {

/// Edges that bend by more than 40 degrees are creases: they are not rounded, and outlines run
/// along them.
inline constexpr float kCosineOfCrease = 0.766f;

/// The corner of a triangle at a vertex.
inline int corner_of(const Triangle& triangle, Index vertex) {
  return triangle[0] == vertex ? 0 : triangle[1] == vertex ? 1 : 2;
}

/// As `vertex_normals` of normals.h, with the result of `vertex_triangles`.
std::vector<Vec3> vertex_normals(const Mesh& mesh, const VertexTriangles& around,
                                 const Progress& progress = {});

/// A triangle's normal and angles, for the normals at its corners.
struct TriangleAngles {
  Vec3 normal;
  std::array<float, 3> angle;  ///< radians; zero without an area
};

/// The same into `normals`, with the scratch array `angles`. Resizes both; allocates nothing if
/// their capacity suffices.
void fill_vertex_normals(const Mesh& mesh, const VertexTriangles& around,
                         std::vector<TriangleAngles>& angles, std::vector<Vec3>& normals,
                         const Progress& progress = {});

}  // namespace brindle
