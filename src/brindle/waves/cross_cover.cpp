#include "brindle/cross_cover.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

#include <Eigen/Geometry>

#include "brindle/base/parallel.h"
#include "brindle/error.h"
#include "brindle/waves/direction_graph.h"

namespace brindle {
namespace {

void check_crosses(const Adjacency& neighborhood, const WaveSet& crosses) {
  const std::size_t nodes = 2 * neighborhood.node_count();
  if (crosses.positions.size() != nodes || crosses.directions.size() != nodes ||
      crosses.frequencies.size() != nodes) {
    throw Error("cross field: there must be two waves for each of " +
                std::to_string(neighborhood.node_count()) + " vertices");
  }
  if (std::max(nodes, 2 * neighborhood.directed_edge_count()) > std::numeric_limits<Index>::max()) {
    throw Error("cross field: the mesh has too many edges; take a smaller mesh");
  }
}

/// Rows keep their order, so that neighbours ascend as they do on the surface.
Adjacency cover_neighborhood(const Adjacency& neighborhood, const WaveSet& crosses) {
  const std::size_t vertices = neighborhood.node_count();
  Adjacency cover;
  cover.offsets.resize(2 * vertices + 1);
  cover.neighbors.resize(2 * neighborhood.directed_edge_count());
  parallel_for(vertices, [&](std::size_t begin, std::size_t end) {
    for (auto i = static_cast<Index>(begin); i < end; ++i) {
      const auto row = neighborhood.of(i);
      const Index first = 2 * neighborhood.offsets[i];
      const auto degree = static_cast<Index>(row.size());
      cover.offsets[2 * i + 1] = first + degree;
      cover.offsets[2 * i + 2] = first + 2 * degree;
      for (Index k = 0; k < degree; ++k) {
        const Index node = 2 * row[k] + matching_wave(crosses, i, row[k]);
        cover.neighbors[first + k] = node;
        cover.neighbors[first + degree + k] = other_wave(node);
      }
    }
  });
  return cover;
}

}  // namespace

WaveSet cross_waves(const WaveSet& waves, std::span<const Vec3> normals) {
  const std::size_t vertices = waves.positions.size();
  WaveSet crosses;
  crosses.positions.resize(2 * vertices);
  crosses.directions.resize(2 * vertices);
  crosses.frequencies.resize(2 * vertices);
  parallel_for(vertices, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      for (std::size_t r = 0; r < 2; ++r) {
        crosses.positions[2 * i + r] = waves.positions[i];
        crosses.frequencies[2 * i + r] = waves.frequencies[i];
      }
      if (normals[i].isZero(0)) {
        crosses.directions[2 * i] = crosses.directions[2 * i + 1] = Vec3::Zero();
        continue;
      }
      crosses.directions[2 * i] = waves.directions[i];
      crosses.directions[2 * i + 1] = normals[i].cross(waves.directions[i]);
    }
  });
  return crosses;
}

Index matching_wave(const WaveSet& crosses, Index i, Index j) {
  const auto alignment = [&](Index r, Index m) {
    return crosses.directions[2 * i + r].dot(crosses.directions[2 * j + m]);
  };
  const float d00 = alignment(0, 0), d01 = alignment(0, 1);
  const float d10 = alignment(1, 0), d11 = alignment(1, 1);
  const float of_normals = d00 * d11 - d01 * d10;
  const float sense = of_normals < kOppositeSides ? -1.0f : 1.0f;
  // After parallel transport from i to j the cross is turned by an angle t against that of j; these
  // are cos t and sin t, both times 1 + |of_normals|.
  return std::abs(d01 - sense * d10) > std::abs(d00 + sense * d11) ? 1 : 0;
}

bool are_matched_alike(const Adjacency& neighborhood, const WaveSet& crosses,
                       const CrossCover& cover) {
  check_crosses(neighborhood, crosses);
  const std::size_t vertices = neighborhood.node_count();
  if (cover.neighborhood->node_count() != 2 * vertices) return false;
  const auto others = parallel_sum<std::size_t>(vertices, [&](std::size_t begin, std::size_t end) {
    std::size_t count = 0;
    for (auto i = static_cast<Index>(begin); i < end; ++i) {
      const auto row = neighborhood.of(i);
      const auto matched = cover.neighborhood->of(2 * i);
      for (std::size_t k = 0; k < row.size(); ++k) {
        // Both ends of an edge have the same matching.
        if (row[k] > i) count += matched[k] != 2 * row[k] + matching_wave(crosses, i, row[k]);
      }
    }
    return count;
  });
  return others == 0;
}

CrossCover cross_cover(const Adjacency& neighborhood, std::span<const Triangle> triangles,
                       WaveSet crosses, const Progress& progress) {
  check_crosses(neighborhood, crosses);
  CrossCover cover;
  cover.neighborhood = std::make_shared<const Adjacency>(cover_neighborhood(neighborhood, crosses));
  for (Index t = 0; t < triangles.size(); ++t) {
    if (t % kReportSlice == 0) progress.tick();
    const auto& [a, b, c] = triangles[t];
    const Index to_b = matching_wave(crosses, a, b);
    const Index to_c = matching_wave(crosses, a, c);
    if (matching_wave(crosses, b, c) != (to_b ^ to_c)) {
      cover.singular.push_back(t);
    } else {
      cover.base.push_back(t);
      cover.triangles.push_back({2 * a, 2 * b + to_b, 2 * c + to_c});
    }
  }
  cover.triangles.reserve(2 * cover.base.size());
  for (std::size_t s = 0; s < cover.base.size(); ++s) {
    const auto& [a, b, c] = cover.triangles[s];
    cover.triangles.push_back({other_wave(a), other_wave(b), other_wave(c)});
  }
  cover.waves = std::move(crosses);
  return cover;
}

}  // namespace brindle
