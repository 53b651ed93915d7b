#include "brindle/pipeline/measured_pattern.h"

#include <utility>

#include "brindle/pattern/point_quality.h"

namespace brindle {
namespace {

PatternQuality quality_of(const Surface& surface, const WaveSet& waves,
                          const StripePattern& pattern) {
  if (!surface.mesh.triangles.empty()) return measure_quality(surface.mesh, waves, pattern.corners);
  return measure_point_quality(*surface.neighborhood, surface.normals, waves, pattern.solution.z,
                               pattern.phase_shift);
}

}  // namespace

std::size_t count_in_calm(std::span<const Triangle> triangles,
                          std::span<const CornerPhases> corners, std::span<const float> calm) {
  std::size_t count = 0;
  for (std::size_t t = 0; t < corners.size(); ++t) {
    const TriangleKind kind = corners[t].kind;
    if (!is_branch(kind)) continue;
    const auto& [a, b, c] = triangles[t];
    count += calm[a] + calm[b] + calm[c] >= 1.5f;
  }
  return count;
}

void measure_pattern(const Surface& surface, std::span<const float> calm, StripePattern& pattern) {
  WaveSet& waves = pattern.waves;
  pattern.corners =
      corner_phases(surface.mesh.triangles, waves, pattern.solution.z, pattern.phase_shift);
  PatternQuality quality = quality_of(surface, waves, pattern);
  quality.spacing_error_wanted_mean = quality.spacing_error_mean;
  if (!pattern.frequencies_wanted.empty()) {
    std::swap(waves.frequencies, pattern.frequencies_wanted);
    quality.spacing_error_wanted_mean = quality_of(surface, waves, pattern).spacing_error_mean;
    std::swap(waves.frequencies, pattern.frequencies_wanted);
  }
  if (!calm.empty()) {
    quality.branches_in_calm = count_in_calm(surface.mesh.triangles, pattern.corners, calm);
  }
  pattern.quality = quality;
}

}  // namespace brindle
