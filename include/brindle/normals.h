/// Unit normals of triangles and vertices.
#pragma once

#include <vector>

#include "brindle/export.h"
#include "brindle/mesh.h"
#include "brindle/types.h"

namespace BRINDLE_EXPORT brindle {

/// The unit normal of a triangle by the right-hand rule; zero if it has no area.
Vec3 triangle_normal(const Mesh& mesh, const Triangle& triangle);

/// One unit normal per vertex: the average of the adjacent triangles' normals, weighted by the
/// angle at the vertex (Thürmer and Wüthrich 1998). Where neighbouring triangles are wound against
/// each other (Möbius strip, triangle soup) the average would cancel; there the normal is the
/// direction that agrees best with all of them up to sign. Zero for a vertex without a triangle.
std::vector<Vec3> vertex_normals(const Mesh& mesh);

}  // namespace brindle
