#include "brindle/corner_phases.h"

#include <algorithm>
#include <string>

#include "brindle/base/parallel.h"
#include "brindle/error.h"
#include "brindle/fragment_phase.h"
#include "brindle/pattern/triangle_kernels.h"

namespace brindle {
namespace {

using Corners = std::array<CornerWave, 3>;

void set_corners(std::size_t lane, const Corners& corners, CornerLanes& lanes) {
  for (std::size_t m = 0; m < 3; ++m) {
    const Wave& wave = corners[m].wave;
    lanes.set(lane, m, wave.position, wave.direction, wave.frequency);
    lanes.set_phase(lane, m, corners[m].z);
  }
}

/// Scalar, because vector code would have to evaluate all cases of the paper's common source.
void set_shifts(std::size_t lane, Corners corners, PhaseShiftKind kind, ShiftLanes& shifts) {
  const auto signs = common_orientation(
      {corners[0].wave.direction, corners[1].wave.direction, corners[2].wave.direction});
  for (int m = 1; m < 3; ++m) {
    if (signs && (*signs)[m] < 0) corners[m] = flipped(corners[m]);
  }
  for (int m = 0; m < 3; ++m) {
    shifts.radians[m][lane] = phase_shift(kind, corners[m].wave, corners[(m + 1) % 3].wave).radians;
  }
}

/// Lifts up to kTriangleLanes triangles; `corners_of(i)` returns the corners of the i-th.
template <class CornersOf>
void lift(std::size_t count, const CornersOf& corners_of, PhaseShiftKind kind,
          CornerPhases* result) {
  CornerLanes lanes;
  ShiftLanes shifts;
  LiftedLanes lifted;
  const bool given = kind == PhaseShiftKind::common_source;
  for (std::size_t lane = 0; lane < kTriangleLanes; ++lane) {
    const Corners corners = corners_of(std::min(lane, count - 1));
    set_corners(lane, corners, lanes);
    if (given) set_shifts(lane, corners, kind, shifts);
  }
  triangle_kernels::lift_corners(lanes, kind, given ? &shifts : nullptr, lifted);
  for (std::size_t lane = 0; lane < count; ++lane) result[lane] = lifted.get(lane);
}

template <class CornersOf>
void lift_into(std::span<CornerPhases> result, const CornersOf& corners_of, PhaseShiftKind kind,
               const Progress& progress) {
  parallel_for(result.size(), progress, [&](std::size_t begin, std::size_t end) {
    for (std::size_t t = begin; t < end; t += kTriangleLanes) {
      lift(
          std::min(kTriangleLanes, end - t), [&](std::size_t i) { return corners_of(t + i); }, kind,
          result.data() + t);
    }
  });
}

template <class CornersOf>
std::vector<CornerPhases> lift_all(std::size_t triangles, const CornersOf& corners_of,
                                   PhaseShiftKind kind, const Progress& progress) {
  std::vector<CornerPhases> result(triangles);
  lift_into(std::span(result), corners_of, kind, progress);
  return result;
}

}  // namespace

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

float lifted_step(const CornerWave& j, const CornerWave& i, PhaseShiftKind kind) {
  return portable::lifted_step(j.z, i.z, phase_shift(kind, j.wave, i.wave).radians);
}

CornerPhases corner_phases(const Corners& corners, PhaseShiftKind kind) {
  CornerLanes lanes;
  ShiftLanes shifts;
  LiftedLanes lifted;
  const bool given = kind == PhaseShiftKind::common_source;
  set_corners(0, corners, lanes);
  if (given) set_shifts(0, corners, kind, shifts);
  portable::lift_first(lanes, kind, given ? &shifts : nullptr, lifted);
  return lifted.get(0);
}

std::vector<CornerPhases> corner_phases(std::span<const Triangle> triangles, const WaveSet& waves,
                                        std::span<const Complex> z, PhaseShiftKind kind,
                                        const Progress& progress) {
  return lift_all(
      triangles.size(), [&](std::size_t t) { return corner_waves(triangles[t], waves, z); }, kind,
      progress);
}

void fill_corner_phases(std::span<const Triangle> triangles, const WaveSet& waves,
                        std::span<const Complex> z, PhaseShiftKind kind,
                        std::span<CornerPhases> corners, const Progress& progress) {
  if (corners.size() != triangles.size()) {
    throw Error("corner phases: there are " + std::to_string(corners.size()) + " entries for " +
                std::to_string(triangles.size()) + " triangles");
  }
  lift_into(
      corners, [&](std::size_t t) { return corner_waves(triangles[t], waves, z); }, kind, progress);
}

std::vector<CornerPhases> corner_phases(std::span<const Corners> triangles, PhaseShiftKind kind,
                                        const Progress& progress) {
  return lift_all(
      triangles.size(), [&](std::size_t t) -> const Corners& { return triangles[t]; }, kind,
      progress);
}

}  // namespace brindle
