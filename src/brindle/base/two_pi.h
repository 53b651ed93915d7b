/// A period, in radians.
#pragma once

#include <numbers>

namespace brindle {

inline constexpr float kTwoPi = 2 * std::numbers::pi_v<float>;

}  // namespace brindle
