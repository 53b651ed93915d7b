/// Unit normals of triangles and vertices.
#pragma once

#include <vector>

#include "brindle/geometry/vertex_triangles.h"
#include "brindle/mesh.h"
#include "brindle/progress.h"

namespace brindle {

/// The unit normal of a triangle by the right-hand rule; zero if it has no area.
Vec3 triangle_normal(const Mesh& mesh, const Triangle& triangle);

/// One unit normal per vertex: the average of the adjacent triangles' normals, weighted by the
/// angle at the vertex (Thürmer and Wüthrich 1998). Where neighbouring triangles are wound against
/// each other (Möbius strip, triangle soup) the average would cancel; there the normal is the
/// direction that agrees best with all of them up to sign. Zero for a vertex without a triangle.
std::vector<Vec3> vertex_normals(const Mesh& mesh);

/// The same, with what `vertex_triangles` found.
std::vector<Vec3> vertex_normals(const Mesh& mesh, const VertexTriangles& around,
                                 const Progress& progress = {});

}  // namespace brindle
