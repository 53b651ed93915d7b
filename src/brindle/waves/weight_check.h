/// The range of anchor weights.
#pragma once

namespace brindle {

/// The largest anchor weight: beyond it, couplings vanish in rounding and sums of squares overflow.
inline constexpr float kLargestWeight = 1e6f;

/// False for NaN.
inline bool is_weight(float weight) { return weight >= 0 && weight <= kLargestWeight; }

}  // namespace brindle
