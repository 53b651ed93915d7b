#include "brindle/corner_phases.h"

#include <cmath>

#include "brindle/base/parallel.h"
#include "brindle/base/two_pi.h"
#include "brindle/fragment_phase.h"

namespace brindle {
namespace {}  // namespace

float lifted_step(const CornerWave& j, const CornerWave& i, PhaseShiftKind kind) {
  const float shift = phase_shift(kind, j.wave, i.wave).radians;
  // The difference of the phases themselves, less the shift, both wrapped.
  const float remainder = std::arg(i.z * std::conj(j.z)) - shift;
  return shift + remainder - kTwoPi * std::round(remainder / kTwoPi);
}

CornerPhases corner_phases(const std::array<CornerWave, 3>& corners, PhaseShiftKind kind) {
  CornerPhases result;
  const std::array<Vec3, 3> directions{corners[0].wave.direction, corners[1].wave.direction,
                                       corners[2].wave.direction};
  for (const Vec3& direction : directions) {
    if (direction.isZero(0)) return result;
  }
  const auto signs = common_orientation(directions);
  if (!signs) {
    result.kind = TriangleKind::field_singularity;
    return result;
  }
  std::array<CornerWave, 3> oriented = corners;
  for (int m = 0; m < 3; ++m) {
    if ((*signs)[m] < 0) oriented[m] = flipped(corners[m]);
    result.sign[m] = static_cast<std::int8_t>((*signs)[m]);
  }
  const float step_1 = lifted_step(oriented[0], oriented[1], kind);
  const float step_2 = lifted_step(oriented[1], oriented[2], kind);
  const float step_0 = lifted_step(oriented[2], oriented[0], kind);
  result.phase[0] = std::arg(oriented[0].z);
  result.phase[1] = result.phase[0] + step_1;
  result.phase[2] = result.phase[1] + step_2;
  result.branch_index = static_cast<std::int8_t>(std::lround((step_1 + step_2 + step_0) / kTwoPi));
  result.kind = result.branch_index == 0 ? TriangleKind::regular : TriangleKind::branch;
  return result;
}

std::vector<CornerPhases> corner_phases(std::span<const Triangle> triangles, const WaveSet& waves,
                                        std::span<const Complex> z, PhaseShiftKind kind) {
  std::vector<CornerPhases> result(triangles.size());
  parallel_for(triangles.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t t = begin; t < end; ++t) {
      result[t] = corner_phases(corner_waves(triangles[t], waves, z), kind);
    }
  });
  return result;
}

}  // namespace brindle
