#include "brindle/pipeline/texture_orientation.h"

#include <algorithm>
#include <memory>
#include <vector>

#include "brindle/base/parallel.h"
#include "brindle/phases/solver.h"

namespace brindle {
namespace {

/// Far less than an edge of the seam weighs, even if all triangles of a piece together pull.
constexpr float kAsItStands = 1e-7f;

bool is_oriented(const TextureWaves& waves, std::size_t t) {
  return run_alike(waves.u[t]) && run_alike(waves.v[t]);
}

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

void orient_triangles(TextureWaves& waves, std::span<const SharedEdge> edges,
                      const Progress& progress) {
  const PhaseGraph graph = triangle_graph(links_of(waves, edges), waves.triangle_count());
  SolverOptions options;
  options.sweeps = 4;
  options.cycles = 4;
  const PhaseSolution solution = solve_phases(graph, options, progress);
  parallel_for(waves.triangle_count(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t t = begin; t < end; ++t) {
      if (solution.z[t].imag() >= 0) continue;
      flip(waves.u[t]);
      flip(waves.v[t]);
    }
  });
}

}  // namespace brindle
