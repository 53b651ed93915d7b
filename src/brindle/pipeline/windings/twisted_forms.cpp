#include "brindle/pipeline/windings/twisted_forms.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

#include "brindle/base/elementary.h"

namespace brindle {

double value_at(const Adjacency& adjacency, std::span<const float> directed, Index from, Index to) {
  const auto row = adjacency.of(from);
  const auto at = std::lower_bound(row.begin(), row.end(), to) - row.begin();
  return static_cast<double>(directed[adjacency.offsets[from] + static_cast<std::size_t>(at)]);
}

LoopWalk walk_round(const SurfaceLoop& loop, std::span<const Vec3> normals, const WaveSet& waves,
                    std::span<const Complex> z, PhaseShiftKind kind) {
  LoopWalk walk;
  const std::size_t count = loop.vertices.size();
  double radians = 0, along = 0, across = 0;
  int sense = 1;
  for (std::size_t i = 0; i < count; ++i) {
    const Index a = loop.vertices[i], b = loop.vertices[(i + 1) % count];
    if (waves.directions[a].isZero(0) || waves.directions[b].isZero(0)) return walk;
    walk.senses.push_back(sense);
    CornerWave here{waves.wave(a), z[a]}, there{waves.wave(b), z[b]};
    if (sense < 0) here = flipped(here);
    sense = here.wave.direction.dot(there.wave.direction) < 0 ? -1 : 1;
    if (sense < 0) there = flipped(there);
    radians += static_cast<double>(lifted_step(here, there, kind));
    const Vec3 way = there.wave.position - here.wave.position;
    const Vec3 waves_run = here.wave.direction + there.wave.direction;
    along += static_cast<double>(waves_run.dot(way));
    across += static_cast<double>(waves_run.dot((normals[a] + normals[b]).cross(way))) / 2;
  }
  if (sense < 0) return walk;
  walk.oriented = true;
  walk.periods = static_cast<int>(std::lround(radians / static_cast<double>(kTwoPi)));
  // If the phase grows along the path and waves point left of it, stripes drift to the right.
  walk.sign =
      std::abs(along) > std::abs(across) ? (walk.periods < 0 ? -1 : 1) : (across > 0 ? -1 : 1);
  return walk;
}

}  // namespace brindle
