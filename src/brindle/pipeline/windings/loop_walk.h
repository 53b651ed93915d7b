/// What waves do on the way round a loop.
#pragma once

#include <vector>

#include "brindle/corner_phases.h"
#include "brindle/surface.h"

namespace brindle {

struct LoopWalk {
  bool oriented = false;    ///< the field can be oriented along the loop, and has waves there
  std::vector<int> senses;  ///< 1 or -1 of every vertex: whether its wave runs like the first one's
  int periods = 0;          ///< gained in the first one's sense
  int sign = 1;             ///< what makes of them the number of `Winding`
  int winding() const { return sign * periods; }
};

LoopWalk walk_round(const SurfaceLoop& loop, std::span<const Vec3> normals, const WaveSet& waves,
                    std::span<const Complex> z, PhaseShiftKind kind);

}  // namespace brindle
