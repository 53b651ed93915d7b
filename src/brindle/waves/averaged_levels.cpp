#include "brindle/waves/averaged_levels.h"

#include <algorithm>
#include <tuple>

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
Merge merge_neighbors(const Adjacency& adjacency, const SurfaceElements& elements) {
  struct Edge {
    float score;
    Index i, j;
  };
  std::vector<Edge> edges;
  edges.reserve(adjacency.edge_count());
  for (Index i = 0; i < adjacency.node_count(); ++i) {
    for (const Index j : adjacency.of(i)) {
      if (j < i) continue;
      const float ratio = elements.areas[i] / elements.areas[j];
      edges.push_back(
          {elements.normals[i].dot(elements.normals[j]) * std::min(ratio, 1 / ratio), i, j});
    }
  }
  std::ranges::sort(edges, [](const Edge& a, const Edge& b) {
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
  for (Index i = 0; i < merge.parent.size(); ++i) {
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
  }
  return coarse;
}

std::shared_ptr<const Adjacency> merged_adjacency(const Adjacency& fine, const Merge& merge) {
  std::vector<std::pair<Index, Index>> edges;
  edges.reserve(fine.neighbors.size());
  for (Index i = 0; i < fine.node_count(); ++i) {
    for (const Index j : fine.of(i)) {
      if (merge.parent[i] != merge.parent[j]) edges.emplace_back(merge.parent[i], merge.parent[j]);
    }
  }
  std::ranges::sort(edges);
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  auto adjacency = std::make_shared<Adjacency>();
  adjacency->offsets.assign(merge.count + 1, 0);
  for (const auto& [i, j] : edges) {
    ++adjacency->offsets[i + 1];
    adjacency->neighbors.push_back(j);
  }
  for (Index i = 0; i < merge.count; ++i) adjacency->offsets[i + 1] += adjacency->offsets[i];
  return adjacency;
}

Wave wave_at(const WaveSet& waves, Index node) {
  return {waves.positions[node], waves.directions[node], waves.frequencies[node]};
}

/// How each node's phase follows from that of its average: by the shift between the two waves.
void set_transfer(AveragedLevel& level, const Nodes& fine, const Nodes& coarse,
                  PhaseShiftKind kind) {
  level.transfer.resize(level.parent.size());
  level.transfer_reflects.resize(level.parent.size());
  for (Index i = 0; i < level.parent.size(); ++i) {
    const PhaseShift shift =
        phase_shift(kind, wave_at(coarse.waves, level.parent[i]), wave_at(fine.waves, i));
    level.transfer_reflects[i] = shift.reflecting;
    level.transfer[i] =
        shift.reflecting ? -std::polar(1.0f, -shift.radians) : std::polar(1.0f, shift.radians);
  }
}

std::shared_ptr<const AveragedLevel> averaged_level(const Adjacency& adjacency, const Nodes& fine,
                                                    PhaseShiftKind kind, int levels) {
  Merge merge = merge_neighbors(adjacency, fine.elements);
  if (levels <= 0 || merge.count == adjacency.node_count()) return nullptr;
  const Nodes coarse = averaged_nodes(fine, merge);
  auto level = std::make_shared<AveragedLevel>();
  level->graph = build_phase_graph(merged_adjacency(adjacency, merge), coarse.waves, kind);
  level->parent = std::move(merge.parent);
  set_transfer(*level, fine, coarse, kind);
  level->graph.averaged = averaged_level(*level->graph.adjacency, coarse, kind, levels - 1);
  return level;
}

}  // namespace

void attach_averaged_levels(PhaseGraph& graph, const WaveSet& waves,
                            const SurfaceElements& elements, PhaseShiftKind kind, int levels) {
  graph.averaged = averaged_level(*graph.adjacency, {waves, elements}, kind, levels);
}

}  // namespace brindle
