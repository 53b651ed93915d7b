#include "brindle/pipeline/texture_orientation.h"

#include <algorithm>
#include <memory>
#include <numeric>
#include <vector>

#include "brindle/base/parallel.h"
#include "brindle/pipeline/short_seam.h"
#include "brindle/solver.h"

namespace brindle {
namespace {

/// Far less than an edge of the seam weighs, even if all triangles of a piece together pull.
constexpr float kAsItStands = 1e-7f;

/// How the waves on both sides of an edge agree: the triangles' corners at one vertex have the same
/// waves up to their signs.
struct Agreement {
  bool u;
  bool v;
};

Agreement agreement(const TextureWaves& waves, const SharedEdge& edge) {
  const auto alike = [&](const std::vector<CornerWaves>& corners) {
    const CornerWave& a = corners[edge.from[0] / 3][edge.from[0] % 3];
    const CornerWave& b = corners[edge.from[1] / 3][edge.from[1] % 3];
    return a.wave.direction.dot(b.wave.direction) > 0;
  };
  return {alike(waves.u), alike(waves.v)};
}

/// One entry of the triangles' graph: `coupling` is what the edges between two triangles add up to.
struct Link {
  Index triangle, neighbor;
  float coupling;
};

std::vector<Link> links_of(const TextureWaves& waves, std::span<const SharedEdge> edges) {
  std::vector<Link> links;
  links.reserve(2 * edges.size());
  for (const SharedEdge& edge : edges) {
    const Index a = edge.from[0] / 3;
    const Index b = edge.from[1] / 3;
    if (a == b || !is_oriented(waves, a) || !is_oriented(waves, b)) continue;
    const auto [u, v] = agreement(waves, edge);
    const float coupling = 0.5f * ((u ? 1.0f : -1.0f) + (v ? 1.0f : -1.0f));
    links.push_back({a, b, coupling});
    links.push_back({b, a, coupling});
  }
  std::sort(links.begin(), links.end(), [](const Link& x, const Link& y) {
    return x.triangle != y.triangle ? x.triangle < y.triangle : x.neighbor < y.neighbor;
  });
  return links;
}

/// Triangles as nodes. Phases stay on the imaginary axis, where the solver starts: +i is "as it
/// stands".
PhaseGraph triangle_graph(const std::vector<Link>& links, std::size_t triangle_count) {
  PhaseGraph graph;
  auto adjacency = std::make_shared<Adjacency>();
  adjacency->offsets.assign(triangle_count + 1, 0);
  for (std::size_t i = 0; i < links.size(); ++i) {
    const bool repeated = i > 0 && links[i].triangle == links[i - 1].triangle &&
                          links[i].neighbor == links[i - 1].neighbor;
    if (repeated) {
      graph.coupling.back() += links[i].coupling;
      continue;
    }
    adjacency->neighbors.push_back(links[i].neighbor);
    graph.coupling.emplace_back(links[i].coupling);
    ++adjacency->offsets[links[i].triangle + 1];
  }
  for (std::size_t t = 0; t < triangle_count; ++t) {
    adjacency->offsets[t + 1] += adjacency->offsets[t];
  }
  graph.reflecting.assign(graph.coupling.size(), 0);
  graph.anchor.assign(triangle_count, Complex(0, kAsItStands));
  graph.adjacency = std::move(adjacency);
  return graph;
}

void turn(TextureWaves& waves, const std::vector<std::uint8_t>& turned) {
  parallel_for(waves.triangle_count(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t t = begin; t < end; ++t) {
      if (!turned[t]) continue;
      flip(waves.u[t]);
      flip(waves.v[t]);
    }
  });
}

/// The smallest member of the set that an item belongs to, and sets that grow together.
class MergedSets {
 public:
  explicit MergedSets(std::size_t count) : parent_(count) {
    std::iota(parent_.begin(), parent_.end(), Index{0});
  }
  Index of(Index item) {
    while (parent_[item] != item) item = parent_[item] = parent_[parent_[item]];
    return item;
  }
  void merge(Index a, Index b) {
    const Index first = of(a), second = of(b);
    parent_[std::max(first, second)] = std::min(first, second);
  }

 private:
  std::vector<Index> parent_;
};

/// For every vertex the node that stands for it. A seam costs nothing along the border and around
/// triangles without orientation: their vertices are one node.
std::vector<Index> seam_nodes(const TextureWaves& waves, std::span<const Triangle> triangles,
                              std::span<const SharedEdge> edges) {
  Index count = 0;
  for (const Triangle& t : triangles) count = std::max({count, t[0] + 1, t[1] + 1, t[2] + 1});
  std::vector<std::uint8_t> shared(3 * triangles.size());
  for (const SharedEdge& edge : edges) {
    for (int i = 0; i < 2; ++i) {
      const Index t = edge.from[i] / 3;
      const Index c = edge.from[i] % 3;
      shared[edge.to[i] % 3 == (c + 1) % 3 ? 3 * t + c : edge.to[i]] = 1;
    }
  }
  MergedSets sets(count);
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    const bool free = !is_oriented(waves, t);
    for (std::size_t c = 0; c < 3; ++c) {
      if (free || !shared[3 * t + c]) sets.merge(triangles[t][c], triangles[t][(c + 1) % 3]);
    }
  }
  std::vector<Index> nodes(count);
  for (Index v = 0; v < count; ++v) nodes[v] = sets.of(v);
  return nodes;
}

/// The edges between triangles with orientation.
std::vector<SeamEdge> seam_edges(const TextureWaves& waves, std::span<const Triangle> triangles,
                                 std::span<const SharedEdge> edges,
                                 const std::vector<Index>& nodes) {
  const auto node_at = [&](Index corner) { return nodes[triangles[corner / 3][corner % 3]]; };
  std::vector<SeamEdge> result;
  for (const SharedEdge& edge : edges) {
    const Index a = edge.from[0] / 3, b = edge.from[1] / 3;
    if (!is_oriented(waves, a) || !is_oriented(waves, b)) continue;
    const auto [u, v] = agreement(waves, edge);
    result.push_back({{node_at(edge.from[0]), node_at(edge.to[0])}, {a, b}, !u && !v});
  }
  return result;
}

}  // namespace

TextureSeams texture_seams(const TextureWaves& waves, std::span<const SharedEdge> edges) {
  TextureSeams seams;
  for (std::size_t t = 0; t < waves.triangle_count(); ++t) {
    seams.unoriented_triangles += !is_oriented(waves, t);
  }
  for (const SharedEdge& edge : edges) {
    if (!is_oriented(waves, edge.from[0] / 3) || !is_oriented(waves, edge.from[1] / 3)) continue;
    const auto [u, v] = agreement(waves, edge);
    seams.turned += !u && !v;
    seams.mirrored += u != v;
  }
  return seams;
}

void orient_triangles(TextureWaves& waves, std::span<const Triangle> triangles,
                      std::span<const SharedEdge> edges, const Progress& progress) {
  const PhaseGraph graph = triangle_graph(links_of(waves, edges), waves.triangle_count());
  SolverOptions options;
  options.sweeps = 4;
  options.cycles = 4;
  const PhaseSolution solution = solve_phases(graph, options, progress);
  std::vector<std::uint8_t> turned(waves.triangle_count());
  for (std::size_t t = 0; t < turned.size(); ++t) turned[t] = solution.z[t].imag() < 0;
  turn(waves, turned);
  progress.report("seams", 0);
  const std::vector<Index> nodes = seam_nodes(waves, triangles, edges);
  const std::vector<SeamEdge> seam = seam_edges(waves, triangles, edges, nodes);
  turn(waves, shortening_turns(seam, nodes.size(), waves.triangle_count()));
}

}  // namespace brindle
