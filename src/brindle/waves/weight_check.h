/// Weights of anchors.
#pragma once

namespace brindle {

/// Beyond, couplings are but rounding, and sums of squares would overflow.
inline constexpr float kLargestWeight = 1e6f;

/// False for what is no number, too.
inline bool is_weight(float weight) { return weight >= 0 && weight <= kLargestWeight; }

}  // namespace brindle
