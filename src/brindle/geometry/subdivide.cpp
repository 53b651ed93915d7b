#include "brindle/geometry/subdivide.h"

#include <algorithm>
#include <limits>
#include <string>
#include <utility>

#include "brindle/base/parallel.h"
#include "brindle/error.h"
#include "brindle/geometry/neighborhood.h"
#include "brindle/mesh.h"

namespace brindle {
namespace {

/// Numbers edges in the order of their smaller, then of their larger end.
class EdgeNumbers {
 public:
  explicit EdgeNumbers(const Mesh& mesh)
      : neighborhood_(vertex_neighborhood(mesh)), first_(mesh.vertex_count() + 1, 0) {
    for (Index v = 0; v < mesh.vertex_count(); ++v) {
      first_[v + 1] = first_[v] + static_cast<Index>(larger(v).size());
    }
  }

  Index count() const { return first_.back(); }
  Index first(Index v) const { return first_[v]; }

  /// The neighbours of v with larger numbers, each at the end of one edge of v.
  std::span<const Index> larger(Index v) const {
    const auto row = neighborhood_.of(v);
    return {std::upper_bound(row.begin(), row.end(), v), row.end()};
  }

  Index operator()(Index a, Index b) const {
    if (a > b) std::swap(a, b);
    const auto row = larger(a);
    return first_[a] +
           static_cast<Index>(std::lower_bound(row.begin(), row.end(), b) - row.begin());
  }

 private:
  Adjacency neighborhood_;
  std::vector<Index> first_;
};

Mesh subdivide_once(Mesh mesh) {
  const EdgeNumbers edges(mesh);
  const auto old_vertices = static_cast<Index>(mesh.vertex_count());
  mesh.positions.resize(mesh.vertex_count() + edges.count());
  parallel_for(old_vertices, [&](std::size_t begin, std::size_t end) {
    for (auto v = static_cast<Index>(begin); v < end; ++v) {
      Index midpoint = old_vertices + edges.first(v);
      for (const Index other : edges.larger(v)) {
        // Halved before the sum, which could overflow.
        mesh.positions[midpoint++] = 0.5f * mesh.positions[v] + 0.5f * mesh.positions[other];
      }
    }
  });
  std::vector<Triangle> finer(4 * mesh.triangle_count());
  parallel_for(mesh.triangle_count(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t t = begin; t < end; ++t) {
      const auto& [a, b, c] = mesh.triangles[t];
      const Index ab = old_vertices + edges(a, b), bc = old_vertices + edges(b, c),
                  ca = old_vertices + edges(c, a);
      finer[4 * t] = {a, ab, ca};
      finer[4 * t + 1] = {ab, b, bc};
      finer[4 * t + 2] = {ca, bc, c};
      finer[4 * t + 3] = {ab, bc, ca};
    }
  });
  mesh.triangles = std::move(finer);
  return mesh;
}

}  // namespace

void check_subdivisions(std::size_t triangles, int times) {
  if (times < 0) throw Error("a mesh cannot be subdivided " + std::to_string(times) + " times");
  std::size_t finer = triangles;
  for (int i = 0; i < times && finer > 0; ++i) {
    finer *= 4;
    // A neighbourhood has up to six entries per triangle.
    if (finer > std::numeric_limits<Index>::max() / 6) {
      throw Error("subdividing " + std::to_string(triangles) + " triangles " +
                  std::to_string(times) + " times makes more than brindle can number; at most " +
                  std::to_string(i) + " times is possible");
    }
  }
}

Mesh subdivide(Mesh mesh, int times) {
  check_subdivisions(mesh.triangle_count(), times);
  for (int i = 0; i < times && !mesh.triangles.empty(); ++i) mesh = subdivide_once(std::move(mesh));
  return mesh;
}

}  // namespace brindle
