/// Tick values of an axis.
#pragma once

#include <vector>

namespace brindle {

/// At least two and at most `most` multiples of 1, 2 or 5 times a power of ten between the ends.
/// The ends themselves if there are none.
std::vector<double> tick_values(double lowest, double highest, int most);

}  // namespace brindle
