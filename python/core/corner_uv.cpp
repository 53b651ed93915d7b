#include "corner_uv.h"

#include <cmath>
#include <limits>

#include "brindle/base/two_pi.h"
#include "brindle/corner_phases.h"

namespace brindle::python {
namespace {

bool has_coordinates(const CornerPhases& corners) {
  return corners.kind == TriangleKind::regular || corners.kind == TriangleKind::branch;
}

// What the corner's phase alone says, and whole tiles: triangles that share a vertex have the same
// fraction there.
float corner_coordinate(const CornerWave& corner, const CornerPhases& phases, int m) {
  const float base = texture_coordinate(phases.sign[m] < 0 ? flipped(corner).z : corner.z);
  return base + std::round(phases.phase[m] / kTwoPi + 0.25f - base);
}

}  // namespace

std::vector<float> corner_coordinates(const TextureWaves& waves, PhaseShiftKind kind) {
  std::vector<float> uv(6 * waves.triangle_count(), std::numeric_limits<float>::quiet_NaN());
  const std::vector<CornerPhases> u = corner_phases(waves.u, kind);
  const std::vector<CornerPhases> v = corner_phases(waves.v, kind);
  for (std::size_t t = 0; t < waves.triangle_count(); ++t) {
    if (!has_coordinates(u[t]) || !has_coordinates(v[t])) continue;
    for (int m = 0; m < 3; ++m) {
      uv[6 * t + 2 * m] = corner_coordinate(waves.u[t][m], u[t], m);
      uv[6 * t + 2 * m + 1] = corner_coordinate(waves.v[t][m], v[t], m);
    }
  }
  return uv;
}

}  // namespace brindle::python
