#include "brindle/geometry/topology.h"

#include <algorithm>

#include "brindle/base/parallel.h"
#include "brindle/base/standard.h"

namespace brindle {
namespace {

/// Fills row v of `rows`, whose rows have two entries per adjacent triangle, with the neighbours of
/// v in ascending order, and returns their number.
Index gather_row(const Mesh& mesh, const VertexTriangles& around, std::size_t v,
                 std::vector<Index>& rows) {
  const auto begin = rows.begin() + 2 * static_cast<std::ptrdiff_t>(around.offsets[v]);
  auto end = begin;
  for (const Index t : around.of(v)) {
    for (const Index corner : mesh.triangles[t]) {
      if (corner != v) *end++ = corner;
    }
  }
  ranges::sort(begin, end);
  return static_cast<Index>(std::unique(begin, end) - begin);
}

}  // namespace

Adjacency vertex_neighborhood(const Mesh& mesh, const Progress& progress) {
  const VertexTriangles around = vertex_triangles(mesh, progress.part(0, 0.3));
  return vertex_neighborhood(mesh, around, progress.part(0.3, 1));
}

Adjacency vertex_neighborhood(const Mesh& mesh, const VertexTriangles& around,
                              const Progress& progress) {
  const std::size_t count = mesh.vertex_count();
  std::vector<Index> rows(2 * around.entries.size());
  Adjacency neighborhood;
  neighborhood.offsets.assign(count + 1, 0);
  parallel_for(count, progress.part(0, 0.7), [&](std::size_t begin, std::size_t end) {
    for (std::size_t v = begin; v < end; ++v) {
      neighborhood.offsets[v + 1] = gather_row(mesh, around, v, rows);
    }
  });
  for (std::size_t v = 0; v < count; ++v) neighborhood.offsets[v + 1] += neighborhood.offsets[v];
  neighborhood.neighbors.resize(neighborhood.offsets[count]);
  parallel_for(count, progress.part(0.7, 1), [&](std::size_t begin, std::size_t end) {
    for (std::size_t v = begin; v < end; ++v) {
      const Index first = neighborhood.offsets[v];
      std::copy_n(rows.begin() + 2 * static_cast<std::ptrdiff_t>(around.offsets[v]),
                  neighborhood.offsets[v + 1] - first, neighborhood.neighbors.begin() + first);
    }
  });
  return neighborhood;
}

}  // namespace brindle
