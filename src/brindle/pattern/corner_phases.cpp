#include "brindle/pattern/corner_phases.h"

#include <cmath>
#include <numbers>

#include "brindle/base/parallel.h"
#include "brindle/pattern/fragment_phase.h"

namespace brindle {
namespace {

constexpr float kTwoPi = 2 * std::numbers::pi_v<float>;

CornerWave corner_wave(const WaveSet& waves, std::span<const Complex> z, Index vertex, float sign) {
  const CornerWave corner{
      {waves.positions[vertex], waves.directions[vertex], waves.frequencies[vertex]}, z[vertex]};
  return sign < 0 ? flipped(corner) : corner;
}

/// Phi_ji plus what is left to the other corner's phase, wrapped: the lifted step from j to i.
float lifted_step(const CornerWave& j, const CornerWave& i, PhaseShiftKind kind) {
  const float shift = phase_shift(kind, j.wave, i.wave).radians;
  // The difference of the phases themselves, less the shift, both wrapped.
  const float remainder = std::arg(i.z * std::conj(j.z)) - shift;
  return shift + remainder - kTwoPi * std::round(remainder / kTwoPi);
}

}  // namespace

CornerPhases corner_phases(const Triangle& triangle, const WaveSet& waves,
                           std::span<const Complex> z, PhaseShiftKind kind) {
  CornerPhases result;
  const std::array<Vec3, 3> directions{waves.directions[triangle[0]], waves.directions[triangle[1]],
                                       waves.directions[triangle[2]]};
  for (const Vec3& direction : directions) {
    if (direction.isZero(0)) return result;
  }
  const auto signs = common_orientation(directions);
  if (!signs) {
    result.kind = TriangleKind::field_singularity;
    return result;
  }
  std::array<CornerWave, 3> corners;
  for (int m = 0; m < 3; ++m) {
    corners[m] = corner_wave(waves, z, triangle[m], (*signs)[m]);
    result.sign[m] = static_cast<std::int8_t>((*signs)[m]);
  }
  const float step_1 = lifted_step(corners[0], corners[1], kind);
  const float step_2 = lifted_step(corners[1], corners[2], kind);
  const float step_0 = lifted_step(corners[2], corners[0], kind);
  result.phase[0] = std::arg(corners[0].z);
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
      result[t] = corner_phases(triangles[t], waves, z, kind);
    }
  });
  return result;
}

}  // namespace brindle
