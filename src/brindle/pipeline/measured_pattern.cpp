#include "brindle/pipeline/measured_pattern.h"

#include <utility>

#include "brindle/pattern/point_quality.h"

namespace brindle {
namespace {

PatternQuality quality_of(const Surface& surface, const WaveSet& waves,
                          const StripePattern& pattern, const Progress& progress) {
  if (!surface.mesh.triangles.empty()) {
    return measure_quality(surface.mesh, waves, pattern.corners, progress);
  }
  return measure_point_quality(*surface.neighborhood, surface.normals, waves, pattern.solution.z,
                               pattern.phase_shift, progress);
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

void measure_pattern(const Surface& surface, std::span<const float> calm, StripePattern& pattern,
                     const Progress& progress) {
  WaveSet& waves = pattern.waves;
  pattern.corners = corner_phases(surface.mesh.triangles, waves, pattern.solution.z,
                                  pattern.phase_shift, progress.part(0, 0.4));
  progress.report(0.4);
  PatternQuality quality = quality_of(surface, waves, pattern, progress.part(0.4, 0.7));
  progress.report(0.7);
  quality.spacing_error_wanted_mean = quality.spacing_error_mean;
  if (!pattern.frequencies_wanted.empty()) {
    // The waves asked for are measured as the pattern's, and put back whatever is thrown.
    struct Swapped {
      StripePattern& pattern;
      explicit Swapped(StripePattern& p) : pattern(p) { swap(); }
      ~Swapped() { swap(); }
      Swapped(const Swapped&) = delete;
      Swapped& operator=(const Swapped&) = delete;
      void swap() { std::swap(pattern.waves.frequencies, pattern.frequencies_wanted); }
    };
    const Swapped wanted(pattern);
    quality.spacing_error_wanted_mean =
        quality_of(surface, waves, pattern, progress.part(0.7, 1)).spacing_error_mean;
  }
  if (!calm.empty()) {
    quality.branches_in_calm = count_in_calm(surface.mesh.triangles, pattern.corners, calm);
  }
  pattern.quality = quality;
}

}  // namespace brindle
