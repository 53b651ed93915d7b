/// Normals of vertices whose triangles are known.
#pragma once

#include <array>
#include <vector>

#include "brindle/geometry/vertex_triangles.h"
#include "brindle/normals.h"
#include "brindle/progress.h"

namespace brindle {

/// As `vertex_normals` of normals.h, with what `vertex_triangles` found.
std::vector<Vec3> vertex_normals(const Mesh& mesh, const VertexTriangles& around,
                                 const Progress& progress = {});

/// What all corners of a triangle tell about their vertices.
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
