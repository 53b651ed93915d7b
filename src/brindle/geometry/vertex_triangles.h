/// The triangles around every vertex.
#pragma once

#include "brindle/base/compressed_rows.h"
#include "brindle/mesh.h"
#include "brindle/progress.h"

namespace brindle {

/// A row a vertex: the triangles that use it, in ascending order.
using VertexTriangles = CompressedRows<Index>;

/// Throws Error if the mesh has more corners than an Index can count, and Cancelled if `progress`
/// asks for it.
VertexTriangles vertex_triangles(const Mesh& mesh, const Progress& progress = {});

}  // namespace brindle
