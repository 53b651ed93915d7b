/// Numbers beside an axis.
#pragma once

#include <vector>

namespace brindle {

/// Numbers, at most `most` and at least two, that are whole multiples of 1, 2 or 5 times a power of
/// ten and lie between the ends. The ends themselves if there are no such numbers.
std::vector<double> tick_values(double lowest, double highest, int most);

}  // namespace brindle
