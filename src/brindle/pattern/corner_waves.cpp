#include "brindle/corner_phases.h"

namespace brindle {

CornerWave flipped(const CornerWave& corner) {
  return {{corner.wave.position, -corner.wave.direction, corner.wave.frequency},
          -std::conj(corner.z)};
}

std::array<CornerWave, 3> corner_waves(const Triangle& triangle, const WaveSet& waves,
                                       std::span<const Complex> z) {
  std::array<CornerWave, 3> corners;
  for (int m = 0; m < 3; ++m) {
    const Index vertex = triangle[m];
    corners[m] = {waves.wave(vertex), z[vertex]};
  }
  return corners;
}

}  // namespace brindle
