#include "brindle/distributed/curves/rank_pattern.h"

#include <algorithm>
#include <numeric>
#include <utility>

#include "brindle/error.h"
#include "brindle/geometry/topology.h"

namespace brindle {
namespace {

/// A wave with its phase, as owners tell others of it.
struct SentPhase {
  Vec3 position;
  Vec3 direction;
  float frequency = 1;
  Complex z;
};

/// Vertices that other ranks may have in triangles of theirs.
std::vector<std::uint8_t> shared_vertices(const RankSurface& surface) {
  std::vector<std::uint8_t> shared(surface.vertex_count());
  std::fill(shared.begin() + surface.graph.own, shared.end(), 1);
  for (const NodeHalo* halo : {&surface.graph.halo, &surface.rest}) {
    for (const HaloNeighbor& neighbor : *halo) {
      for (const Index node : neighbor.sent) shared[node] = 1;
    }
  }
  return shared;
}

/// An edge with how many triangles one rank has at it.
struct CountedEdge {
  std::uint64_t low, high;
  std::uint64_t triangles;

  auto ends() const { return std::pair(low, high); }
};

/// How many triangles all ranks have at the edges asked for, list by list.
std::vector<std::vector<std::uint64_t>> totals(const std::vector<std::vector<CountedEdge>>& asked) {
  std::vector<CountedEdge> known;
  for (const auto& list : asked) known.insert(known.end(), list.begin(), list.end());
  std::ranges::sort(known, {}, &CountedEdge::ends);
  std::vector<std::vector<std::uint64_t>> answers(asked.size());
  for (std::size_t r = 0; r < asked.size(); ++r) {
    for (const CountedEdge& edge : asked[r]) {
      std::uint64_t total = 0;
      auto one = std::ranges::lower_bound(known, edge.ends(), {}, &CountedEdge::ends);
      for (; one != known.end() && one->ends() == edge.ends(); ++one) total += one->triangles;
      answers[r].push_back(total);
    }
  }
  return answers;
}

EdgeBeyond beyond(std::uint64_t own, std::uint64_t all) {
  if (all == own) return EdgeBeyond::nothing;
  return all == 2 ? EdgeBeyond::triangle : EdgeBeyond::nonmanifold;
}

}  // namespace

RankTriangles rank_triangles(const RankSurface& surface) {
  const std::size_t count = surface.piece_ids.size();
  RankTriangles result;
  result.of_piece.resize(count);
  std::iota(result.of_piece.begin(), result.of_piece.end(), Index{0});
  std::ranges::sort(result.of_piece, {}, [&](Index v) { return surface.piece_ids[v]; });
  std::vector<Index> number(surface.vertex_count());
  for (Index v = 0; v < count; ++v) {
    const Index here = surface.vertex_of_piece[result.of_piece[v]];
    number[here] = v;
    result.ids.push_back(surface.piece_ids[result.of_piece[v]]);
    result.normals.push_back(surface.normals[here]);
    result.mesh.positions.push_back(surface.mesh.positions[here]);
  }
  result.mesh.origin = surface.mesh.origin;
  for (const auto& [a, b, c] : surface.mesh.triangles) {
    result.mesh.triangles.push_back({number[a], number[b], number[c]});
  }
  result.edges = mesh_edges(result.mesh, vertex_neighborhood(result.mesh));
  return result;
}

void check_pattern(const PiecePattern& pattern) {
  const RankSurface& surface = pattern.surface.rank_surface();
  const WaveSet& waves = pattern.waves;
  const std::size_t vertices = surface.vertex_of_piece.size();
  surface.ranks->together([&] {
    for (const std::size_t count : {waves.positions.size(), waves.directions.size(),
                                    waves.frequencies.size(), pattern.z.size()}) {
      if (count == vertices) continue;
      throw Error("a pattern of a piece of " + std::to_string(vertices) + " vertices has " +
                  std::to_string(count) + " waves or phases; give one for each");
    }
  });
}

RankWaves rank_waves(const PiecePattern& pattern, const RankTriangles& triangles) {
  const RankSurface& surface = pattern.surface.rank_surface();
  check_pattern(pattern);
  std::vector<SentPhase> phases(surface.vertex_count());
  for (std::size_t p = 0; p < pattern.z.size(); ++p) {
    phases[surface.vertex_of_piece[p]] = {pattern.waves.positions[p], pattern.waves.directions[p],
                                          pattern.waves.frequencies[p], pattern.z[p]};
  }
  surface.exchange_all(std::span(phases));
  RankWaves result;
  for (const Index p : triangles.of_piece) {
    const SentPhase& phase = phases[surface.vertex_of_piece[p]];
    result.waves.positions.push_back(phase.position);
    result.waves.directions.push_back(phase.direction);
    result.waves.frequencies.push_back(phase.frequency);
    result.z.push_back(phase.z);
  }
  return result;
}

WavePattern wave_pattern(const RankTriangles& triangles, const RankWaves& waves,
                         PhaseShiftKind phase_shift) {
  return {triangles.mesh, triangles.edges, triangles.normals, waves.waves, waves.z, phase_shift};
}

std::vector<EdgeBeyond> edges_beyond(const RankSurface& surface, const RankTriangles& triangles) {
  Communicator& ranks = *surface.ranks;
  const auto size = static_cast<std::size_t>(ranks.size());
  std::vector<EdgeBeyond> result(triangles.edges.count(), EdgeBeyond::nothing);
  if (size == 1) return result;
  const std::vector<std::uint8_t> shared = shared_vertices(surface);
  const auto is_shared = [&](Index v) {
    return shared[surface.vertex_of_piece[triangles.of_piece[v]]] != 0;
  };
  std::vector<std::vector<CountedEdge>> asked(size);
  std::vector<std::vector<Index>> edges(size);
  for (Index e = 0; e < result.size(); ++e) {
    const auto [a, b] = triangles.edges.vertices[e];
    if (!is_shared(a) || !is_shared(b)) continue;
    const std::uint64_t low = triangles.ids[a];
    asked[low % size].push_back({low, triangles.ids[b], triangles.edges.triangle_count(e)});
    edges[low % size].push_back(e);
  }
  const auto all = ranks.swap_lists(totals(ranks.swap_lists(asked)));
  for (std::size_t r = 0; r < size; ++r) {
    for (std::size_t i = 0; i < edges[r].size(); ++i) {
      result[edges[r][i]] = beyond(asked[r][i].triangles, all[r][i]);
    }
  }
  return result;
}

}  // namespace brindle
