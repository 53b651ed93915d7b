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
  words.detail = "Field Smoothing 1";
  words.singularities = "Field Singularities";
  words.source = "the frequency is not finite, or the field";
  return words;
}

/// The finer waves of U and V, by edges per period.
const WaveFigures& finest(const RunFigures& figures) {
  if (!figures.crossing) return figures.waves;
  return std::min(figures.waves, *figures.crossing, [](const auto& a, const auto& b) {
    return a.edges_per_period_median < b.edges_per_period_median;
  });
}

/// Of the whole surface.
std::size_t triangle_count(const PatternSurface& surface) {
  if (surface.piece) return surface.piece->surface().triangle_count();
  return surface.surface->mesh.triangle_count();
}

}  // namespace

WaveFigures wave_figures(const PatternSurface& surface, const WaveSet& waves) {
  if (surface.piece) return measure_waves(surface.piece->surface(), waves);
  return measure_waves(*surface.surface, waves);
}

std::vector<std::string> warnings_of(const RunFigures& figures, const PatternSurface& surface) {
  if (figures.waves.without_wave == figures.waves.used) return {kNoWave};
  const WarningWords words = words_of_panels();
  std::vector<std::string> sentences = wave_warnings(figures.waves, words);
  const auto add = [&](const std::vector<std::string>& more) {
    for (const std::string& sentence : more) {
      if (std::ranges::find(sentences, sentence) == sentences.end()) sentences.push_back(sentence);
    }
  };
  if (figures.crossing) add(wave_warnings(*figures.crossing, words));
  add(quality_warnings(finest(figures), figures.quality, triangle_count(surface), words));
  if (figures.measured) {
    add(noise_warnings(figures.quality.field_singularities, triangle_count(surface), words));
  }
  add(turn_warnings(figures.turned_apart));
  if (figures.detail) add(detail_warnings(*figures.detail, words));
  return sentences;
}

}  // namespace brindle::paraview
