#include "brindle/waves/averaged_levels.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <tuple>

#include "brindle/base/elementary.h"
#include "brindle/base/parallel.h"
#include "brindle/error.h"

namespace brindle {
namespace {

struct Nodes {
  WaveSet waves;
  SurfaceElements elements;
};

struct Merge {
  std::vector<Index> parent;
  Index count = 0;
};

/// Merges edges in the order of Jakob et al.'s score <n_i, n_j> min(A_i / A_j, A_j / A_i).
Merge merge_neighbors(const Adjacency& adjacency, const SurfaceElements& elements,
                      const Progress& progress) {
  struct Edge {
    float score;
    Index i, j;
  };
  std::vector<Edge> edges;
  edges.reserve(adjacency.edge_count());
  for (Index i = 0; i < adjacency.node_count(); ++i) {
    if (i % kReportSlice == 0) progress.tick();
    for (const Index j : adjacency.of(i)) {
      if (j < i) continue;
      const float ratio = elements.areas[i] / elements.areas[j];
      edges.push_back(
          {elements.normals[i].dot(elements.normals[j]) * std::min(ratio, 1 / ratio), i, j});
    }
  }
  ticking_sort(edges.begin(), edges.end(), progress, [](const Edge& a, const Edge& b) {
    return std::tuple(-a.score, a.i, a.j) < std::tuple(-b.score, b.i, b.j);
  });
  constexpr Index kFree = ~Index{0};
  Merge merge{std::vector<Index>(adjacency.node_count(), kFree), 0};
  for (const Edge& edge : edges) {
    if (merge.parent[edge.i] != kFree || merge.parent[edge.j] != kFree) continue;
    merge.parent[edge.i] = merge.parent[edge.j] = merge.count++;
  }
  for (Index& parent : merge.parent) {
    if (parent == kFree) parent = merge.count++;
  }
  return merge;
}

Nodes averaged_nodes(const Nodes& fine, const Merge& merge) {
  Nodes coarse;
  coarse.waves = {std::vector<Vec3>(merge.count, Vec3::Zero()),
                  std::vector<Vec3>(merge.count, Vec3::Zero()), std::vector<float>(merge.count)};
  coarse.elements = {std::vector<Vec3>(merge.count, Vec3::Zero()), std::vector<float>(merge.count)};
  for (std::size_t i = 0; i < merge.parent.size(); ++i) {
    const Index parent = merge.parent[i];
    const float area = fine.elements.areas[i];
    Vec3& direction = coarse.waves.directions[parent];
    const float sign = direction.dot(fine.waves.directions[i]) < 0 ? -1.0f : 1.0f;
    direction += sign * area * fine.waves.directions[i];
    coarse.waves.positions[parent] += area * fine.waves.positions[i];
    coarse.waves.frequencies[parent] += area * fine.waves.frequencies[i];
    coarse.elements.normals[parent] += area * fine.elements.normals[i];
    coarse.elements.areas[parent] += area;
  }
  for (Index parent = 0; parent < merge.count; ++parent) {
    const float area = coarse.elements.areas[parent];
    coarse.waves.positions[parent] /= area;
    coarse.waves.frequencies[parent] /= area;
    coarse.elements.normals[parent].normalize();
    Vec3& direction = coarse.waves.directions[parent];
    direction -= direction.dot(coarse.elements.normals[parent]) * coarse.elements.normals[parent];
    direction.normalize();
    // With tiny areas squares underflow.
    if (std::abs(direction.squaredNorm() - 1) > 1e-3f) direction.stableNormalize();
  }
  return coarse;
}

/// A neighbourhood and the factors of its edges; none if all are 1.
struct WeightedEdges {
  std::shared_ptr<const Adjacency> adjacency;
  std::vector<float> weights;
};

/// All fine edges between different coarse nodes, sorted by these nodes.
std::vector<std::tuple<Index, Index, float>> merged_edges(const Adjacency& fine,
                                                          std::span<const float> weights,
                                                          const Merge& merge,
                                                          const Progress& progress) {
  std::vector<std::tuple<Index, Index, float>> edges;
  edges.reserve(fine.neighbors.size());
  for (std::size_t i = 0; i < fine.node_count(); ++i) {
    for (Index edge = fine.offsets[i]; edge < fine.offsets[i + 1]; ++edge) {
      const Index from = merge.parent[i], to = merge.parent[fine.neighbors[edge]];
      if (from != to) edges.emplace_back(from, to, weights.empty() ? 1.0f : weights[edge]);
    }
  }
  // Finally by weights, so that both directions of an edge add them in the same order.
  ticking_sort(edges.begin(), edges.end(), progress, std::less<>());
  return edges;
}

WeightedEdges merge_edges(const Adjacency& fine, std::span<const float> weights, const Merge& merge,
                          const Progress& progress) {
  const auto edges = merged_edges(fine, weights, merge, progress);
  progress.tick();
  auto adjacency = std::make_shared<Adjacency>();
  adjacency->offsets.assign(merge.count + 1, 0);
  WeightedEdges merged;
  for (std::size_t first = 0, end = 0; first < edges.size(); first = end) {
    const auto& [i, j, smallest] = edges[first];
    double sum = 0;
    for (; end < edges.size() && std::get<0>(edges[end]) == i && std::get<1>(edges[end]) == j;
         ++end) {
      sum += std::get<2>(edges[end]);
    }
    ++adjacency->offsets[i + 1];
    adjacency->neighbors.push_back(j);
    if (!weights.empty()) {
      merged.weights.push_back(static_cast<float>(sum / static_cast<double>(end - first)));
    }
  }
  for (Index i = 0; i < merge.count; ++i) adjacency->offsets[i + 1] += adjacency->offsets[i];
  merged.adjacency = std::move(adjacency);
  return merged;
}

/// The phase of a node follows from that of its average by the shift between the two waves.
void set_transfer(AveragedLevel& level, const Nodes& fine, const Nodes& coarse,
                  PhaseShiftKind kind) {
  level.transfer.resize(level.parent.size());
  level.transfer_reflects.resize(level.parent.size());
  for (Index i = 0; i < level.parent.size(); ++i) {
    const PhaseShift shift =
        phase_shift(kind, coarse.waves.wave(level.parent[i]), fine.waves.wave(i));
    level.transfer_reflects[i] = shift.reflecting;
    level.transfer[i] = shift.reflecting ? -elementary::polar(1.0f, -shift.radians)
                                         : elementary::polar(1.0f, shift.radians);
  }
}

}  // namespace

std::vector<AveragedLevel> averaged_levels(const Adjacency& adjacency, const WaveSet& waves,
                                           const SurfaceElements& elements, PhaseShiftKind kind,
                                           int levels, std::span<const float> edge_weights,
                                           const Progress& progress) {
  if (!edge_weights.empty() && edge_weights.size() != adjacency.directed_edge_count()) {
    throw Error("averaged levels: there must be one edge weight per directed edge");
  }
  std::vector<AveragedLevel> result;
  const Adjacency* fine_adjacency = &adjacency;
  WeightedEdges edges{nullptr, {edge_weights.begin(), edge_weights.end()}};
  Nodes fine{waves, elements};
  for (int l = 0; l < levels; ++l) {
    // A level takes half the time of the one before.
    const Progress of_level = progress.part(1 - std::pow(0.5, l), 1 - std::pow(0.5, l + 1));
    of_level.report(0);
    Merge merge = merge_neighbors(*fine_adjacency, fine.elements, of_level.part(0, 0.5));
    if (merge.count == fine_adjacency->node_count()) break;
    of_level.tick();
    Nodes coarse = averaged_nodes(fine, merge);
    edges = merge_edges(*fine_adjacency, edges.weights, merge, of_level.part(0.5, 1));
    of_level.tick();
    AveragedLevel level;
    level.graph = build_phase_graph(edges.adjacency, coarse.waves, kind, edges.weights);
    level.parent = std::move(merge.parent);
    set_transfer(level, fine, coarse, kind);
    result.push_back(std::move(level));
    fine_adjacency = result.back().graph.adjacency.get();
    fine = std::move(coarse);
  }
  return result;
}

}  // namespace brindle
