/// Normals of vertices whose triangles are known.
#pragma once

#include <vector>

#include "brindle/geometry/vertex_triangles.h"
#include "brindle/normals.h"
#include "brindle/progress.h"

namespace brindle {

/// As `vertex_normals` of normals.h, with what `vertex_triangles` found.
std::vector<Vec3> vertex_normals(const Mesh& mesh, const VertexTriangles& around,
                                 const Progress& progress = {});

}  // namespace brindle
