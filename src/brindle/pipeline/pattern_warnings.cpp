#include "brindle/pattern_warnings.h"

#include <utility>

#include "brindle/base/text.h"

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

std::vector<std::string> detail_warnings(const FieldDetailFigures& figures,
                                         const WarningWords& words) {
  if (figures.singularities_too_many == 0) return {};
  return {formatted("%zu singularities of the field are left, %zu more than ",
                    figures.singularities, figures.singularities_too_many) +
          words.singularities + " asks for: no pair of opposite ones undoes them"};
}

}  // namespace brindle
