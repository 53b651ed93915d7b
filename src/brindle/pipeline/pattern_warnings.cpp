#include "brindle/pattern_warnings.h"

#include <utility>

namespace brindle {

std::vector<std::string> pattern_warnings(const Surface& surface, const StripePattern& pattern,
                                          const WarningWords& words) {
  WaveFigures figures;
  if (pattern.frequencies_wanted.empty()) {
    figures = measure_waves(surface, pattern.waves);
  } else {
    WaveSet wanted = pattern.waves;
    wanted.frequencies = pattern.frequencies_wanted;
    figures = measure_waves(surface, wanted);
  }
  std::vector<std::string> result = surface_warnings(surface, words.join);
  const auto add = [&](std::vector<std::string> more) {
    for (std::string& sentence : more) result.push_back(std::move(sentence));
  };
  add(wave_warnings(figures, words));
  add(branch_warnings(figures, pattern.quality.branches, surface.mesh.triangle_count(), words));
  return result;
}

}  // namespace brindle
