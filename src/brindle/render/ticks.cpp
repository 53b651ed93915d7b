#include "brindle/render/ticks.h"

#include <algorithm>
#include <cmath>

namespace brindle {

std::vector<double> tick_values(double lowest, double highest, int most) {
  if (!(highest > lowest)) return {lowest};
  const double rough = (highest - lowest) / std::max(most - 1, 1);
  const double power = std::pow(10.0, std::floor(std::log10(rough)));
  double step = 10 * power;
  for (const double factor : {1.0, 2.0, 5.0}) {
    if (factor * power >= rough * (1 - 1e-9)) {
      step = factor * power;
      break;
    }
  }
  std::vector<double> values;
  const double slack = 1e-6 * step;
  for (double k = std::ceil((lowest - slack) / step); k * step <= highest + slack; ++k) {
    values.push_back(k * step);
  }
  if (values.size() < 2) return {lowest, highest};
  return values;
}

}  // namespace brindle
