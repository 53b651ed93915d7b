/// The range of anchor weights.
#pragma once

namespace brindle {

/// With larger ones couplings would be lost in rounding, and sums of squares would overflow.
inline constexpr float kLargestWeight = 1e6f;

/// False for NaN.
inline bool is_weight(float weight) { return weight >= 0 && weight <= kLargestWeight; }

}  // namespace brindle
