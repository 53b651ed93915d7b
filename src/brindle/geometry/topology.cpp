#include "brindle/geometry/topology.h"

#include <algorithm>
#include <string>
#include <tuple>
#include <utility>

#include "brindle/base/parallel.h"
#include "brindle/base/standard.h"
#include "brindle/error.h"

namespace brindle {
namespace {

/// Fills row v of `rows` with the sorted neighbours of v and returns their number. Rows have two
/// entries per adjacent triangle.
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

/// For every vertex the number of its first edge to a lower vertex, plus an end entry.
std::vector<Index> first_edges(const Adjacency& neighborhood) {
  std::vector<Index> first(neighborhood.node_count() + 1, 0);
  for (Index v = 0; v < neighborhood.node_count(); ++v) {
    const auto row = neighborhood.of(v);
    const auto lower = std::lower_bound(row.begin(), row.end(), v) - row.begin();
    first[v + 1] = first[v] + static_cast<Index>(lower);
  }
  return first;
}

/// A side of a triangle, stored at its vertex of lower number.
struct FiledSide {
  Index high;  ///< its other vertex
  Index corner_of_low, corner_of_high;
};

/// All sides in the rows of their lower vertices, sorted by triangle.
CompressedRows<FiledSide> sides_by_vertex(std::span<const Triangle> triangles,
                                          const Progress& progress) {
  Index count = 0;
  for (const Triangle& t : triangles) count = std::max({count, t[0] + 1, t[1] + 1, t[2] + 1});
  return compressed_rows<FiledSide>(count, progress, [&](const Progress& part, const auto& add) {
    reported_for(triangles.size(), part, [&](std::size_t t) {
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
    });
  });
}

/// Calls `visit` for each pair of consecutive sides with the same ends.
template <class Visit>
void for_all_pairs(std::span<const FiledSide> sides, const Visit& visit) {
  for (std::size_t i = 1; i < sides.size(); ++i) {
    if (sides[i - 1].high == sides[i].high) visit(sides[i - 1], sides[i]);
  }
}

Index half_edge_between(Index a, Index b) { return next_in_triangle(a) == b ? a : b; }

/// Whether the triangles of every vertex form a single fan.
bool fans_are_single(const Mesh& mesh, const std::vector<Index>& twins) {
  std::vector<Index> valence(mesh.vertex_count(), 0);
  std::vector<Index> start(mesh.vertex_count(), 0);
  for (Index h = 0; h < twins.size(); ++h) {
    const Index v = vertex_at(mesh.triangles, h);
    ++valence[v];
    start[v] = h;
  }
  for (std::size_t v = 0; v < valence.size(); ++v) {
    if (valence[v] == 0) continue;
    Index walked = 0;
    Index h = start[v];
    do {
      h = twins[previous_in_triangle(h)];
      ++walked;
    } while (h != start[v]);
    if (walked != valence[v]) return false;
  }
  return true;
}

}  // namespace

VertexTriangles vertex_triangles(const Mesh& mesh, const Progress& progress) {
  // A neighbourhood has up to six entries per triangle, numbered by an Index.
  if (mesh.triangle_count() > std::numeric_limits<Index>::max() / 6) {
    throw Error("the mesh has " + std::to_string(mesh.triangle_count()) +
                " triangles, more than brindle can number; split it into parts");
  }
  const auto add_all = [&](const Progress& part, const auto& add) {
    reported_for(mesh.triangle_count(), part, [&](std::size_t t) {
      for (const Index vertex : mesh.triangles[t]) add(vertex, static_cast<Index>(t));
    });
  };
  return compressed_rows<Index>(mesh.vertex_count(), progress, add_all);
}

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

MeshEdges mesh_edges(const Mesh& mesh, const Adjacency& neighborhood, const Progress& progress) {
  const std::vector<Index> first = first_edges(neighborhood);
  progress.report(0.1);
  MeshEdges edges;
  edges.vertices.resize(first.back());
  parallel_for(neighborhood.node_count(), progress.part(0.1, 0.3),
               [&](std::size_t begin, std::size_t end) {
                 for (auto v = static_cast<Index>(begin); v < end; ++v) {
                   for (Index e = first[v]; e < first[v + 1]; ++e) {
                     edges.vertices[e] = {neighborhood.of(v)[e - first[v]], v};
                   }
                 }
               });
  edges.of_triangle.resize(mesh.triangle_count());
  // A triangle with two equal corners has no edge between them: any other edge will do.
  const Index last = std::max(first.back(), Index{1}) - 1;
  parallel_for(
      mesh.triangle_count(), progress.part(0.3, 0.7), [&](std::size_t begin, std::size_t end) {
        for (std::size_t t = begin; t < end; ++t) {
          for (int m = 0; m < 3; ++m) {
            const auto [low, high] =
                std::minmax(mesh.triangles[t][m], mesh.triangles[t][(m + 1) % 3]);
            const auto row = neighborhood.of(high);
            const auto place = std::lower_bound(row.begin(), row.end(), low) - row.begin();
            edges.of_triangle[t][m] = std::min(first[high] + static_cast<Index>(place), last);
          }
        }
      });
  const auto add_all = [&](const Progress& part, const auto& add) {
    if (edges.vertices.empty()) return;
    reported_for(mesh.triangle_count(), part, [&](std::size_t t) {
      for (Index m = 0; m < 3; ++m) {
        add(edges.of_triangle[t][m], 3 * static_cast<Index>(t) + m);
      }
    });
  };
  edges.half_edges = compressed_rows<Index>(edges.count(), progress.part(0.7, 1), add_all);
  return edges;
}

Index MeshEdges::between(Index a, Index b) const {
  const std::array<Index, 2> wanted = {std::min(a, b), std::max(a, b)};
  const auto at = std::lower_bound(
      vertices.begin(), vertices.end(), wanted,
      [](const auto& x, const auto& y) { return std::pair(x[1], x[0]) < std::pair(y[1], y[0]); });
  return static_cast<Index>(at - vertices.begin());
}

std::vector<SharedEdge> shared_edges(std::span<const Triangle> triangles,
                                     const Progress& progress) {
  if (triangles.size() > std::numeric_limits<Index>::max() / 3) {
    throw Error("the mesh has too many triangles; take a smaller one");
  }
  CompressedRows<FiledSide> sides = sides_by_vertex(triangles, progress.part(0, 0.4));
  const std::size_t vertices = sides.size();
  std::vector<Index> first(vertices + 1, 0);
  parallel_for(vertices, progress.part(0.4, 0.8), [&](std::size_t begin, std::size_t end) {
    for (std::size_t v = begin; v < end; ++v) {
      const std::span<FiledSide> around = sides.of(v);
      ranges::stable_sort(around, {}, &FiledSide::high);
      for_all_pairs(around, [&](const FiledSide&, const FiledSide&) { ++first[v + 1]; });
    }
  });
  for (std::size_t v = 0; v < vertices; ++v) first[v + 1] += first[v];
  std::vector<SharedEdge> edges(first[vertices]);
  parallel_for(vertices, progress.part(0.8, 1), [&](std::size_t begin, std::size_t end) {
    for (std::size_t v = begin; v < end; ++v) {
      Index next = first[v];
      for_all_pairs(sides.of(v), [&](const FiledSide& a, const FiledSide& b) {
        edges[next++] = {{a.corner_of_low, b.corner_of_low}, {a.corner_of_high, b.corner_of_high}};
      });
    }
  });
  return edges;
}

std::vector<Index> twins_of(std::span<const Triangle> triangles, const Progress& progress) {
  std::vector<Index> twins(3 * triangles.size(), kNoTwin);
  for (const SharedEdge& edge : shared_edges(triangles, progress)) {
    const Index a = half_edge_between(edge.from[0], edge.to[0]);
    const Index b = half_edge_between(edge.from[1], edge.to[1]);
    if (twins[a] == kNoTwin && twins[b] == kNoTwin && a / 3 != b / 3) {
      twins[a] = b;
      twins[b] = a;
      continue;
    }
    for (const Index h : {a, b}) {
      if (twins[h] < kManyTwins) twins[twins[h]] = kManyTwins;
      twins[h] = kManyTwins;
    }
  }
  return twins;
}

std::optional<std::vector<Index>> manifold_twins(const Mesh& mesh, const Progress& progress) {
  std::vector<Index> twins = twins_of(mesh.triangles, progress);
  for (Index h = 0; h < twins.size(); ++h) {
    if (twins[h] >= kManyTwins) return std::nullopt;
    if (vertex_at(mesh.triangles, h) == vertex_at(mesh.triangles, twins[h])) return std::nullopt;
  }
  if (!fans_are_single(mesh, twins)) return std::nullopt;
  return twins;
}

/// Triangles are compared at their smallest corner.
std::vector<Index> first_with_same_corners(const Mesh& mesh) {
  struct Entry {
    Index middle, largest, triangle;
  };
  std::vector<Index> first(mesh.triangle_count());
  const VertexTriangles around = vertex_triangles(mesh);
  parallel_for(mesh.vertex_count(), [&](std::size_t begin, std::size_t end) {
    std::vector<Entry> entries;
    for (std::size_t v = begin; v < end; ++v) {
      entries.clear();
      for (const Index number : around.of(v)) {
        Triangle t = mesh.triangles[number];
        ranges::sort(t.begin(), t.end());
        if (t[0] == v) entries.push_back({t[1], t[2], number});
      }
      ranges::sort(entries.begin(), entries.end(), [](const Entry& x, const Entry& y) {
        return std::tie(x.middle, x.largest, x.triangle) <
               std::tie(y.middle, y.largest, y.triangle);
      });
      for (std::size_t i = 0; i < entries.size(); ++i) {
        const Entry& entry = entries[i];
        const bool same = i > 0 && entries[i - 1].middle == entry.middle &&
                          entries[i - 1].largest == entry.largest;
        first[entry.triangle] = same ? first[entries[i - 1].triangle] : entry.triangle;
      }
    }
  });
  return first;
}

}  // namespace brindle
