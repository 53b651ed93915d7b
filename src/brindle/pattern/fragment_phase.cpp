#include "brindle/fragment_phase.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "brindle/base/elementary.h"

namespace brindle {
namespace {

// render/shaders/fragment_phase.glsl mirrors this file: same names, same order of statements.
// Change both together; tests/render/renderer_test.cpp compares them.

/// Mismatches beyond this many turns are distributed evenly along their edge. Around a branch the
/// three mismatches sum to a turn: a third each if the branch is centred in the triangle.
constexpr float kMostMismatch = 1.0f / 3;

/// The lower bound of corner weights.
constexpr float kLeastWeight = 1e-4f;

bool runs_against(const Vec3& a, const Vec3& b) { return a.dot(b) < 0; }

/// exp(2 pi i turns). Whole turns are removed first: sine and cosine of large angles lose digits,
/// differently on each machine.
Complex turned(float turns) {
  const float angle = 2 * std::numbers::pi_v<float> * (turns - std::floor(turns + 0.5f));
  return {elementary::cos(angle), elementary::sin(angle)};
}

bool all_have_waves(const std::array<CornerWave, 3>& corners) {
  for (const CornerWave& corner : corners) {
    if (corner.wave.direction.squaredNorm() == 0) return false;
  }
  return true;
}

bool comes_first(const Vec3& a, const Vec3& b) {
  if (a.x() != b.x()) return a.x() < b.x();
  if (a.y() != b.y()) return a.y() < b.y();
  return a.z() < b.z();
}

/// The phase in turns from the nearest peak, -1/2 to 1/2; reversing a wave negates it.
float turns_from_peak(Complex z) {
  return elementary::atan2(-z.real(), z.imag()) / (2 * std::numbers::pi_v<float>);
}

/// The phase gained along an edge, in turns.
struct EdgeTurns {
  float shift = 0;     ///< the phase shift
  float mismatch = 0;  ///< the wrapped remainder, at most half a turn either way
  float gain() const { return shift + mismatch; }
};

/// From corner a to corner b, oriented alike. Both triangles of an edge get the same result, down
/// to rounding, for both orientations of the waves: at a mismatch of half a turn, both must choose
/// the same side.
EdgeTurns turns_between(const CornerWave& a, const CornerWave& b) {
  const bool backward = comes_first(b.wave.position, a.wave.position);
  const CornerWave& first = backward ? b : a;
  const CornerWave& second = backward ? a : b;
  const bool reversed = comes_first(first.wave.direction, Vec3::Zero());
  const float distance = aligned_distance(first.wave.position, first.wave.direction,
                                          second.wave.position, second.wave.direction);
  const float shift = std::sqrt(first.wave.frequency * second.wave.frequency) * distance;
  const float rest = turns_from_peak(second.z) - turns_from_peak(first.z) - shift;
  const float mismatch = reversed ? -rest : rest;
  const float wrapped = mismatch - std::floor(mismatch + 0.5f);
  const float sign = backward ? -1.0f : 1.0f;
  return {sign * shift, (reversed ? -sign : sign) * wrapped};
}

/// A triangle's corners in turn, each reversed if it runs against the previous one. Around a
/// singularity of the field, the first corner returns reversed.
struct Round {
  std::array<CornerWave, 4> corners;
  std::array<bool, 4> turned_round{};
  std::array<EdgeTurns, 3> edges;  ///< from corner m to m + 1
};

/// Positions become relative to the first corner, to keep precision far from the origin.
Round passed_round(const std::array<CornerWave, 3>& corners) {
  Round round;
  for (int m = 0; m < 4; ++m) {
    const CornerWave& corner = corners[m % 3];
    if (m > 0) {
      const Vec3& last = corners[m - 1].wave.direction;
      round.turned_round[m] =
          round.turned_round[m - 1] != runs_against(last, corner.wave.direction);
    }
    round.corners[m] = round.turned_round[m] ? flipped(corner) : corner;
  }
  for (int m = 0; m < 3; ++m) {
    round.edges[m] = turns_between(round.corners[m], round.corners[m + 1]);
  }
  for (CornerWave& corner : round.corners) corner.wave.position -= corners[0].wave.position;
  return round;
}

/// The phase gained from a corner to a point with the wave `there`, in turns.
float turns_to(const Vec3& point, const FragmentWave& there, const Wave& corner) {
  const float distance =
      aligned_distance(corner.position, corner.direction, point, there.direction);
  return std::sqrt(corner.frequency * there.frequency) * distance;
}

float excess_of(const EdgeTurns& edge) {
  return edge.mismatch - std::clamp(edge.mismatch, -kMostMismatch, kMostMismatch);
}

/// The number m of the edge (corner m to m + 1) opposite the corner of least weight.
int nearest_edge(const Vec3& barycentric) {
  const int c = barycentric[1] < barycentric[0] ? 1 : 0;
  return ((barycentric[2] < barycentric[c] ? 2 : c) + 1) % 3;
}

float square(float x) { return x * x; }

/// Eq. 13 and 14 for corners that run alike. Sums of nearly opposite waves would jump from one to
/// the other midway. So each wave is first advanced by its share of its edges' excess mismatch.
FragmentWave blended_wave(const Round& round, const Vec3& barycentric, const Vec3& point) {
  FragmentWave fragment;
  for (int m = 0; m < 3; ++m) {
    const Wave& wave = round.corners[m].wave;
    fragment.direction += barycentric[m] * wave.direction;
    fragment.frequency += barycentric[m] * wave.frequency;
  }
  fragment.direction.normalize();
  Complex sum = 0;
  for (int m = 0; m < 3; ++m) {
    const int next = (m + 1) % 3;
    const int last = (m + 2) % 3;
    const float ahead = excess_of(round.edges[m]) * barycentric[next] -
                        excess_of(round.edges[last]) * barycentric[last];
    const float turns = turns_to(point, fragment, round.corners[m].wave) + ahead;
    sum += barycentric[m] * round.corners[m].z * turned(turns);
  }
  const float length = std::abs(sum);
  fragment.z = length > 0 ? sum / length : Complex(0);
  return fragment;
}

/// The phase at corner m of a field singularity, in turns from that at its barycentre. Once around
/// the triangle, the phase returns reversed, up to whole turns. Half of these turns is the only
/// phase that equals its own reverse, a peak or a trough: that of the barycentre.
struct TurnsFromCentre {
  std::array<float, 3> corners;
  float centre;  ///< in turns from a peak
};

TurnsFromCentre turns_from_centre(const Round& round) {
  const float start = turns_from_peak(round.corners[0].z);
  float turns = start;
  TurnsFromCentre result;
  for (int m = 0; m < 3; ++m) {
    result.corners[m] = turns;
    turns += round.edges[m].gain();
  }
  result.centre = 0.5f * std::floor(turns + start + 0.5f);
  for (int m = 0; m < 3; ++m) result.corners[m] -= result.centre;
  return result;
}

/// The phase at a point from edge m alone, in turns, if the edge's first corner has `at_corner`. On
/// the edge it equals `blended_wave` in the neighbouring triangle.
float turns_beside(const Round& round, int m, const Vec3& barycentric, const Vec3& point,
                   float at_corner, FragmentWave& fragment) {
  const CornerWave& from = round.corners[m];
  const CornerWave& to = round.corners[m + 1];
  const float a = barycentric[m];
  const float b = barycentric[(m + 1) % 3];
  const float share = b / (a + b);
  const float rest = 1 - share;
  fragment.direction = (rest * from.wave.direction + share * to.wave.direction).normalized();
  fragment.frequency = rest * from.wave.frequency + share * to.wave.frequency;
  const float excess = excess_of(round.edges[m]);
  const float turns = turns_to(point, fragment, from.wave);
  const float turns_b = turns_to(point, fragment, to.wave);
  const Complex sum = rest * from.z * turned(turns + excess * share) +
                      share * to.z * turned(turns_b - excess * rest);
  const float led = rest * turns + share * (round.edges[m].gain() + turns_b);
  const float off = turns_from_peak(sum) - turns_from_peak(from.z) - led;
  return at_corner + led + off - std::floor(off + 0.5f);
}

/// The wave in a field singularity, oriented like corner m of the nearest edge. Near a corner, both
/// of its edges are blended; towards the middle of an edge, only that edge remains. Towards the
/// barycentre, the phase approaches the phase there.
FragmentWave singular_wave(const Round& round, const Vec3& barycentric, const Vec3& point) {
  const int m = nearest_edge(barycentric);
  const bool at_first = barycentric[m] >= barycentric[(m + 1) % 3];
  const int second = (at_first ? m + 2 : m + 1) % 3;
  const bool reversed = at_first ? m == 0 : m == 2;
  const Vec3 b = barycentric.cwiseMax(kLeastWeight);
  const float least = b[(m + 2) % 3];
  const float most = at_first ? b[m] : b[(m + 1) % 3];
  const float middle = at_first ? b[(m + 1) % 3] : b[m];
  const float weight = square(middle * (most - least));
  const float weight_of_second = square(least * (most - middle));
  const float total = weight + weight_of_second;
  const float share = total > 0 ? weight_of_second / total : 0.5f;

  const TurnsFromCentre turns = turns_from_centre(round);
  FragmentWave fragment;
  float own = 0, other = 0;
  for (int edge = share > 0 ? 1 : 0; edge >= 0; --edge) {
    const int corner = edge == 1 ? second : m;
    (edge == 1 ? other : own) =
        turns_beside(round, corner, barycentric, point, turns.corners[corner], fragment);
  }
  const float inside = square(27 * b[0] * b[1] * b[2]);
  const float way = std::sqrt(std::max(1 - inside, 0.0f));
  const float blended = own + share * ((reversed ? -other : other) - own);
  fragment.z = turned(turns.centre + way * blended + 0.25f);
  return fragment;
}

FragmentWave wave_in(const Round& round, const Vec3& barycentric) {
  Vec3 point = Vec3::Zero();
  for (int m = 0; m < 3; ++m) point += barycentric[m] * round.corners[m].wave.position;
  return round.turned_round[3] ? singular_wave(round, barycentric, point)
                               : blended_wave(round, barycentric, point);
}

FragmentWave split_wave_in(const Round& round, const Vec3& barycentric) {
  FragmentWave fragment = wave_in(round, barycentric);
  if (round.turned_round[nearest_edge(barycentric)]) {
    fragment.direction = -fragment.direction;
    fragment.z = -std::conj(fragment.z);
  }
  return fragment;
}

void at_each(const std::array<CornerWave, 3>& corners, std::span<const Vec3> barycentric,
             std::span<FragmentWave> waves,
             FragmentWave (*wave_at)(const Round& round, const Vec3& barycentric)) {
  if (!all_have_waves(corners)) {
    std::fill_n(waves.begin(), barycentric.size(), FragmentWave());
    return;
  }
  const Round round = passed_round(corners);
  std::transform(barycentric.begin(), barycentric.end(), waves.begin(),
                 [&](const Vec3& b) { return wave_at(round, b); });
}

}  // namespace

std::optional<std::array<float, 3>> common_orientation(const std::array<Vec3, 3>& directions) {
  const bool turn_second = runs_against(directions[0], directions[1]);
  const bool turn_third = runs_against(directions[0], directions[2]);
  if (runs_against(directions[1], directions[2]) != (turn_second != turn_third)) return {};
  return {{1.0f, turn_second ? -1.0f : 1.0f, turn_third ? -1.0f : 1.0f}};
}

FragmentWave fragment_phase(const std::array<CornerWave, 3>& corners, const Vec3& barycentric) {
  if (!all_have_waves(corners)) return {};
  return wave_in(passed_round(corners), barycentric);
}

FragmentWave split_fragment_phase(const std::array<CornerWave, 3>& corners,
                                  const Vec3& barycentric) {
  if (!all_have_waves(corners)) return {};
  return split_wave_in(passed_round(corners), barycentric);
}

void fragment_phases(const std::array<CornerWave, 3>& corners, std::span<const Vec3> barycentric,
                     std::span<FragmentWave> waves) {
  at_each(corners, barycentric, waves, wave_in);
}

void split_fragment_phases(const std::array<CornerWave, 3>& corners,
                           std::span<const Vec3> barycentric, std::span<FragmentWave> waves) {
  at_each(corners, barycentric, waves, split_wave_in);
}

}  // namespace brindle
