#include "brindle/phases/multilevel.h"

#include <algorithm>

namespace brindle {

void descend(Hierarchy& hierarchy, int sweeps) {
  auto& levels = hierarchy.levels;
  std::ranges::fill(levels.back().z, kPeak);
  for (std::size_t l = levels.size(); l-- > 0;) {
    if (l + 1 < levels.size()) prolong(levels[l + 1], levels[l]);
    for (int s = 0; s < sweeps; ++s) sweep(levels[l].layout(), levels[l].couplings, levels[l].z);
  }
}

}  // namespace brindle
