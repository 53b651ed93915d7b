#include "brindle/geometry/topology.h"

#include <algorithm>
#include <array>
#include <limits>

#include "brindle/base/compressed_rows.h"
#include "brindle/base/parallel.h"
#include "brindle/base/standard.h"
#include "brindle/error.h"

namespace brindle {
namespace {

/// A side of a triangle, filed under its vertex of lower number.
struct FiledSide {
  Index high;  ///< its other vertex
  Index corner_of_low, corner_of_high;
};

/// All sides in the rows of their lower vertices, in ascending order of triangles.
CompressedRows<FiledSide> sides_by_vertex(std::span<const Triangle> triangles) {
  Index count = 0;
  for (const Triangle& t : triangles) count = std::max({count, t[0] + 1, t[1] + 1, t[2] + 1});
  return compressed_rows<FiledSide>(count, [&](const auto& add) {
    for (std::size_t t = 0; t < triangles.size(); ++t) {
      const auto first = static_cast<Index>(3 * t);
      for (Index c = 0; c < 3; ++c) {
        const Index next = (c + 1) % 3;
        const Index a = triangles[t][c], b = triangles[t][next];
        if (a < b) {
          add(a, {b, first + c, first + next});
        } else {
          add(b, {a, first + next, first + c});
        }
      }
    }
  });
}

/// Calls `visit` for each pair of sides with the same ends, one after the other.
template <class Visit>
void for_all_pairs(std::span<const FiledSide> sides, const Visit& visit) {
  for (std::size_t i = 1; i < sides.size(); ++i) {
    if (sides[i - 1].high == sides[i].high) visit(sides[i - 1], sides[i]);
  }
}

}  // namespace

std::vector<SharedEdge> shared_edges(std::span<const Triangle> triangles) {
  if (triangles.size() > std::numeric_limits<Index>::max() / 3) {
    throw Error("the mesh has too many triangles; take a smaller one");
  }
  CompressedRows<FiledSide> sides = sides_by_vertex(triangles);
  const std::size_t vertices = sides.size();
  std::vector<Index> first(vertices + 1, 0);
  parallel_for(vertices, [&](std::size_t begin, std::size_t end) {
    for (std::size_t v = begin; v < end; ++v) {
      const std::span<FiledSide> around = sides.of(v);
      ranges::stable_sort(around, {}, &FiledSide::high);
      for_all_pairs(around, [&](const FiledSide&, const FiledSide&) { ++first[v + 1]; });
    }
  });
  for (std::size_t v = 0; v < vertices; ++v) first[v + 1] += first[v];
  std::vector<SharedEdge> edges(first[vertices]);
  parallel_for(vertices, [&](std::size_t begin, std::size_t end) {
    for (std::size_t v = begin; v < end; ++v) {
      Index next = first[v];
      for_all_pairs(sides.of(v), [&](const FiledSide& a, const FiledSide& b) {
        edges[next++] = {{a.corner_of_low, b.corner_of_low}, {a.corner_of_high, b.corner_of_high}};
      });
    }
  });
  return edges;
}

}  // namespace brindle
