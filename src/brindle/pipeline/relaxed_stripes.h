/// Solves again for waves that changed after the frequency relaxation.
#pragma once

#include "brindle/stripe_pattern.h"

namespace brindle {

/// As `stripe_pattern`, but with fixed frequencies. Those of `waves` come from the pattern
/// `before`, which has the requested frequencies and the relaxation's change.
StripePattern resolve_with_frequencies(const Surface& surface, WaveSet waves,
                                       const StripePattern& before, const StripeOptions& options,
                                       const Progress& progress = {});

}  // namespace brindle
