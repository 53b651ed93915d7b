#include "warnings.h"

#include <algorithm>

#include <brindle/distributed_pattern.h>
#include <brindle/pattern_warnings.h>

namespace brindle::paraview {
namespace {

constexpr const char* kNoWave =
    "no point has a wave, and there are no stripes: at each the field is zero, not finite or "
    "normal to the surface, or the frequency is not finite";

WarningWords words_of_panels() {
  WarningWords words;
  words.fewer =
      "take fewer Stripes, or a lower Frequency, which counts stripes per unit of the mesh's own "
      "length";
  words.subdivide = "apply the filter Subdivide before, Number of Subdivisions:";
  words.field = "Field";
  words.smoothing = "Field Smoothing 1";
  words.singularities = "Field Singularities";
  words.source = "the frequency is not finite, or the field";
  return words;
}

/// The finer waves of U and V, by edges per period.
const WaveMetrics& finest(const RunMetrics& metrics) {
  if (!metrics.crossing) return metrics.waves;
  return std::min(metrics.waves, *metrics.crossing, [](const auto& a, const auto& b) {
    return a.edges_per_period_median < b.edges_per_period_median;
  });
}

/// Of the whole surface.
std::size_t triangle_count(const PatternSurface& surface) {
  if (surface.piece) return surface.piece->surface().triangle_count();
  return surface.surface->mesh.triangle_count();
}

}  // namespace

WaveMetrics wave_metrics(const PatternSurface& surface, const WaveSet& waves) {
  if (surface.piece) return measure_waves(surface.piece->surface(), waves);
  return measure_waves(*surface.surface, waves);
}

std::vector<std::string> warnings_of(const RunMetrics& metrics, const PatternSurface& surface) {
  if (metrics.waves.without_wave == metrics.waves.used) return {kNoWave};
  const WarningWords words = words_of_panels();
  std::vector<std::string> sentences = wave_warnings(metrics.waves, words);
  const auto add = [&](const std::vector<std::string>& more) {
    for (const std::string& sentence : more) {
      if (std::ranges::find(sentences, sentence) == sentences.end()) sentences.push_back(sentence);
    }
  };
  if (metrics.crossing) add(wave_warnings(*metrics.crossing, words));
  add(quality_warnings(finest(metrics), metrics.quality, triangle_count(surface), words));
  if (metrics.measured) {
    add(noise_warnings(metrics.quality.field_singularities, triangle_count(surface), words));
  }
  add(turn_warnings(metrics.turned_apart));
  if (metrics.smoothing) add(smoothing_warnings(*metrics.smoothing, words));
  return sentences;
}

}  // namespace brindle::paraview
