/// Normals of vertices whose triangles are known.
#pragma once

#include <array>
#include <vector>

#include "brindle/geometry/topology.h"
#include "brindle/normals.h"
#include "brindle/progress.h"

namespace brindle {

/// Where a surface bends by more than 40 degrees between triangles, it has a crease: it is not
/// rounded there, and outlines run along it.
inline constexpr float kCosineOfCrease = 0.766f;

/// Which corner of a triangle a vertex is.
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

/// The same into `normals`, by `angles` of the triangles, both as large as they must be afterwards:
/// allocates nothing if they have been that large before.
void fill_vertex_normals(const Mesh& mesh, const VertexTriangles& around,
                         std::vector<TriangleAngles>& angles, std::vector<Vec3>& normals,
                         const Progress& progress = {});

}  // namespace brindle
