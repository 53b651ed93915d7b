/// Stripes along waves that were changed after their frequencies had yielded.
#pragma once

#include "brindle/stripe_pattern.h"

namespace brindle {

/// As `stripe_pattern`, but with frequencies as they are: those of `waves` come from the pattern
/// `before`, which knows what was asked for and how far they had yielded.
StripePattern resolve_with_frequencies(const Surface& surface, WaveSet waves,
                                       const StripePattern& before, const StripeOptions& options,
                                       const Progress& progress = {});

}  // namespace brindle
