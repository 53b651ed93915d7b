#include "brindle/pipeline/fields/surface_elements.h"

#include <algorithm>
#include <numbers>
#include <numeric>

#include "brindle/base/parallel.h"
#include "brindle/geometry/measures.h"

namespace brindle {
namespace {

/// Lower bound, for edges opposite obtuse angles.
constexpr float kLeastCotangent = 0.01f;

/// Assumes that the neighbours fill a disc evenly.
std::vector<float> point_areas(const Surface& surface) {
  std::vector<float> areas(surface.mesh.vertex_count());
  parallel_for(areas.size(), [&](std::size_t begin, std::size_t end) {
    for (Index i = static_cast<Index>(begin); i < end; ++i) {
      const auto row = surface.neighborhood->of(i);
      float squares = 0;
      for (const Index j : row) {
        squares += (surface.mesh.positions[j] - surface.mesh.positions[i]).squaredNorm();
      }
      const auto count = static_cast<float>(row.size());
      if (count > 0) areas[i] = 2 * std::numbers::pi_v<float> * squares / (count * count);
    }
  });
  return areas;
}

/// 4 A / (sum of squared lengths) at each end.
std::vector<float> point_stiffness(const Adjacency& neighborhood) {
  std::vector<float> stiffness(neighborhood.directed_edge_count());
  const auto half = [&](Index i) {
    const auto count = static_cast<float>(neighborhood.of(i).size());
    return 4 * std::numbers::pi_v<float> / (count * count);
  };
  parallel_for(neighborhood.node_count(), [&](std::size_t begin, std::size_t end) {
    for (Index i = static_cast<Index>(begin); i < end; ++i) {
      for (Index e = neighborhood.offsets[i]; e < neighborhood.offsets[i + 1]; ++e) {
        stiffness[e] = half(i) + half(neighborhood.neighbors[e]);
      }
    }
  });
  return stiffness;
}

}  // namespace

std::vector<float> edge_stiffness(const Surface& surface, const Progress& progress) {
  if (surface.mesh.triangles.empty()) return point_stiffness(*surface.neighborhood);
  std::vector<float> stiffness = edge_cotangents(surface.mesh, *surface.neighborhood, progress);
  for (float& value : stiffness) value = std::max(value, kLeastCotangent);
  return stiffness;
}

std::vector<float> stiffness_sums(const Adjacency& adjacency, std::span<const float> stiffness) {
  std::vector<float> sums(adjacency.node_count());
  parallel_for(sums.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const auto first = stiffness.begin() + adjacency.offsets[i];
      const auto last = stiffness.begin() + adjacency.offsets[i + 1];
      sums[i] = std::accumulate(first, last, 0.0f);
    }
  });
  return sums;
}

PhaseGraph stiffness_graph(const Surface& surface, std::span<const float> stiffness) {
  PhaseGraph graph;
  graph.adjacency = surface.neighborhood;
  graph.coupling.assign(stiffness.begin(), stiffness.end());
  graph.reflecting.assign(stiffness.size(), 0);
  return graph;
}

std::vector<float> areas_of_triangles(const Mesh& mesh) {
  std::vector<float> areas(mesh.triangle_count());
  parallel_for(areas.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t t = begin; t < end; ++t) areas[t] = triangle_area(mesh, mesh.triangles[t]);
  });
  return areas;
}

std::vector<float> areas_of_vertices(const Surface& surface, std::span<const float> of_triangles) {
  if (of_triangles.empty()) return point_areas(surface);
  std::vector<float> areas(surface.mesh.vertex_count());
  for (std::size_t t = 0; t < of_triangles.size(); ++t) {
    for (const Index v : surface.mesh.triangles[t]) areas[v] += of_triangles[t] / 3;
  }
  return areas;
}

}  // namespace brindle
