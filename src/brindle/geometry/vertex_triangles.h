/// The triangles around every vertex.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "brindle/mesh.h"
#include "brindle/progress.h"

namespace brindle {

/// Compressed rows: the triangles that use vertex v are `triangles[offsets[v]] ..
/// triangles[offsets[v + 1] - 1]`, in ascending order.
struct VertexTriangles {
  std::vector<Index> offsets{0};  ///< vertices + 1 entries
  std::vector<Index> triangles;   ///< one entry per triangle corner

  std::span<const Index> of(std::size_t vertex) const {
    return std::span(triangles).subspan(offsets[vertex], offsets[vertex + 1] - offsets[vertex]);
  }
};

/// Throws Error if the mesh has more corners than an Index can count, and Cancelled if `progress`
/// asks for it.
VertexTriangles vertex_triangles(const Mesh& mesh, const Progress& progress = {});

}  // namespace brindle
