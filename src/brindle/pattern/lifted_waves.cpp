#include "brindle/pattern/lifted_waves.h"

#include "brindle/base/error.h"
#include "brindle/base/parallel.h"

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

LiftedWaves::LiftedWaves(const WavePattern& pattern) : pattern_(pattern) {
  check_sizes(pattern);
  turns_.resize(pattern.mesh.vertex_count());
  parallel_for(turns_.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t v = begin; v < end; ++v) {
      turns_[v] = turns_after_peak(wave_of(static_cast<Index>(v)).z);
    }
  });
  const auto& vertices = pattern.edges.vertices;
  const auto& directions = pattern.waves.directions;
  edges_.resize(vertices.size());
  parallel_for(vertices.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t e = begin; e < end; ++e) {
      const auto [a, b] = vertices[e];
      if (directions[a].isZero(0) || directions[b].isZero(0)) continue;
      edges_[e] = lift_edge(wave_of(a), turns_[a], wave_of(b), turns_[b], pattern.phase_shift);
    }
  });
}

CornerWave LiftedWaves::wave_of(Index vertex) const {
  const WaveSet& waves = pattern_.waves;
  return canonical({{waves.positions[vertex], waves.directions[vertex], waves.frequencies[vertex]},
                    pattern_.z[vertex]});
}

LiftedTriangle LiftedWaves::triangle(std::size_t t) const {
  const Triangle& vertices = pattern_.mesh.triangles[t];
  std::array<CornerWave, 3> corners;
  std::array<Turns, 3> turns{};
  std::array<EdgeLift, 3> edges;
  for (int m = 0; m < 3; ++m) {
    corners[m] = wave_of(vertices[m]);
    turns[m] = turns_[vertices[m]];
    edges[m] = edges_[pattern_.edges.of_triangle[t][m]];
  }
  return lifted_triangle(vertices, corners, turns, edges);
}

}  // namespace brindle
