/// What follows from a pattern's phases.
#pragma once

#include <span>

#include "brindle/stripe_pattern.h"

namespace brindle {

/// Renews `corners` and `quality`, the latter also against the frequencies asked for, from the
/// other parts of the pattern. `calm` is that of a Slack.
void measure_pattern(const Surface& surface, std::span<const float> calm, StripePattern& pattern);

}  // namespace brindle
