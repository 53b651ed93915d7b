#include "brindle/pattern/lifted_waves.h"

#include "brindle/base/parallel.h"
#include "brindle/error.h"

namespace brindle {
namespace {

void check_sizes(const WavePattern& pattern) {
  const std::size_t count = pattern.mesh.vertex_count();
  const WaveSet& waves = pattern.waves;
  if (waves.positions.size() != count || waves.directions.size() != count ||
      waves.frequencies.size() != count || pattern.z.size() != count ||
      pattern.normals.size() != count) {
    throw Error("curves need one wave, one phase and one normal per vertex");
  }
  if (pattern.edges.of_triangle.size() != pattern.mesh.triangle_count()) {
    throw Error("the edges are not those of this mesh");
  }
}

}  // namespace

LiftedWaves::LiftedWaves(const WavePattern& pattern, const Progress& progress) : pattern_(pattern) {
  check_sizes(pattern);
  const WaveSet& waves = pattern.waves;
  waves_.resize(pattern.mesh.vertex_count());
  turns_.resize(waves_.size());
  parallel_for(waves_.size(), progress.part(0, 0.3), [&](std::size_t begin, std::size_t end) {
    for (std::size_t v = begin; v < end; ++v) {
      waves_[v] = canonical({waves.wave(v), pattern.z[v]});
      turns_[v] = waves.directions[v].isZero(0) ? 0 : turns_after_peak(waves_[v].z);
    }
  });
  const auto& vertices = pattern.edges.vertices;
  edges_.resize(vertices.size());
  parallel_for(vertices.size(), progress.part(0.3, 1), [&](std::size_t begin, std::size_t end) {
    for (std::size_t e = begin; e < end; ++e) {
      const auto [a, b] = vertices[e];
      if (turns_[a] == 0 || turns_[b] == 0) continue;
      edges_[e] = lift_edge(waves_[a], turns_[a], waves_[b], turns_[b], pattern.phase_shift);
    }
  });
}

LiftedTriangle LiftedWaves::triangle(std::size_t t) const {
  const Triangle& vertices = pattern_.mesh.triangles[t];
  std::array<Turns, 3> turns{};
  std::array<EdgeLift, 3> edges;
  for (int m = 0; m < 3; ++m) {
    turns[m] = turns_[vertices[m]];
    if (turns[m] == 0) return {};
    edges[m] = edges_[pattern_.edges.of_triangle[t][m]];
  }
  return lifted_triangle(vertices, turns, edges);
}

}  // namespace brindle
