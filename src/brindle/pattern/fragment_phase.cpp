#include "brindle/fragment_phase.h"

#include <cmath>
#include <numbers>

namespace brindle {
namespace {

// The twin of this file is render/shaders/fragment_phase.glsl: same names, same order of
// statements. Change both or neither; tests/render/renderer_test.cpp compares them.

bool runs_against(const Vec3& a, const Vec3& b) { return a.dot(b) < 0; }

/// exp(2 pi i turns). Whole turns go first: sine and cosine of large angles lose digits, and each
/// machine loses others.
Complex turned(float turns) {
  const float angle = 2 * std::numbers::pi_v<float> * (turns - std::floor(turns + 0.5f));
  return {std::cos(angle), std::sin(angle)};
}

/// Eq. 13 and 14 at `point` for corners that run alike, with weights that sum to 1.
FragmentWave blended_wave(const std::array<CornerWave, 3>& corners, const Vec3& weights,
                          const Vec3& point) {
  FragmentWave fragment;
  for (int m = 0; m < 3; ++m) {
    fragment.direction += weights[m] * corners[m].wave.direction;
    fragment.frequency += weights[m] * corners[m].wave.frequency;
  }
  fragment.direction.normalize();
  Complex sum = 0;
  for (int m = 0; m < 3; ++m) {
    const Wave& wave = corners[m].wave;
    const float distance =
        aligned_distance(wave.position, wave.direction, point, fragment.direction);
    const float turns = std::sqrt(wave.frequency * fragment.frequency) * distance;
    sum += weights[m] * corners[m].z * turned(turns);
  }
  const float length = std::abs(sum);
  fragment.z = length > 0 ? sum / length : Complex(0);
  return fragment;
}

bool all_have_waves(const std::array<CornerWave, 3>& corners) {
  for (const CornerWave& corner : corners) {
    if (corner.wave.direction.squaredNorm() == 0) return false;
  }
  return true;
}

/// Positions relative to the first corner: they keep their digits far from the origin.
std::array<CornerWave, 3> moved_to_first_corner(const std::array<CornerWave, 3>& corners) {
  std::array<CornerWave, 3> moved = corners;
  for (CornerWave& corner : moved) corner.wave.position -= corners[0].wave.position;
  return moved;
}

Vec3 point_at(const std::array<CornerWave, 3>& corners, const Vec3& barycentric) {
  return barycentric[0] * corners[0].wave.position + barycentric[1] * corners[1].wave.position +
         barycentric[2] * corners[2].wave.position;
}

/// The corner opposite to the sub-triangle of the barycentric split that holds the fragment.
int opposite_corner(const Vec3& barycentric) {
  const int c = barycentric[1] < barycentric[0] ? 1 : 0;
  return barycentric[2] < barycentric[c] ? 2 : c;
}

/// The fragment's wave from the two corners of the edge that its sub-triangle keeps. The third
/// corner has no weight anywhere in the sub-triangle. So the value on the edge is the edge's own,
/// and the value on a cut from a corner to the barycentre is that corner's alone, seen from either
/// side: nothing jumps but at the barycentre itself, which becomes the singular point.
FragmentWave split_wave(std::array<CornerWave, 3> corners, const Vec3& barycentric,
                        const Vec3& point) {
  const int c = opposite_corner(barycentric);
  const int a = (c + 1) % 3;
  const int b = (c + 2) % 3;
  const Vec3 excess = barycentric - Vec3::Constant(barycentric[c]);
  const float total = excess[a] + excess[b];
  if (!(total > 0)) return {};
  if (runs_against(corners[a].wave.direction, corners[b].wave.direction)) {
    corners[b] = flipped(corners[b]);
  }
  return blended_wave(corners, excess / total, point);
}

}  // namespace

std::optional<std::array<float, 3>> common_orientation(const std::array<Vec3, 3>& directions) {
  const bool turn_second = runs_against(directions[0], directions[1]);
  const bool turn_third = runs_against(directions[0], directions[2]);
  if (runs_against(directions[1], directions[2]) != (turn_second != turn_third)) return {};
  return {{1.0f, turn_second ? -1.0f : 1.0f, turn_third ? -1.0f : 1.0f}};
}

FragmentWave oriented_fragment_phase(const std::array<CornerWave, 3>& corners,
                                     const Vec3& barycentric) {
  if (!all_have_waves(corners)) return {};
  const std::array<CornerWave, 3> moved = moved_to_first_corner(corners);
  return blended_wave(moved, barycentric, point_at(moved, barycentric));
}

FragmentWave split_fragment_phase(const std::array<CornerWave, 3>& corners,
                                  const Vec3& barycentric) {
  if (!all_have_waves(corners)) return {};
  const std::array<CornerWave, 3> moved = moved_to_first_corner(corners);
  return split_wave(moved, barycentric, point_at(moved, barycentric));
}

FragmentWave fragment_phase(const std::array<CornerWave, 3>& corners, const Vec3& barycentric) {
  if (!all_have_waves(corners)) return {};
  std::array<CornerWave, 3> moved = moved_to_first_corner(corners);
  const Vec3 point = point_at(moved, barycentric);
  const auto signs = common_orientation(
      {moved[0].wave.direction, moved[1].wave.direction, moved[2].wave.direction});
  if (!signs) return split_wave(moved, barycentric, point);
  for (int m = 1; m < 3; ++m) {
    if ((*signs)[m] < 0) moved[m] = flipped(moved[m]);
  }
  return blended_wave(moved, barycentric, point);
}

}  // namespace brindle
