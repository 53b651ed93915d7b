/// Numbers that the tests of several modules use.
#pragma once

#include <limits>
#include <numbers>

namespace brindle::testing_support {

inline constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();
inline constexpr float kInfinity = std::numeric_limits<float>::infinity();
inline constexpr float kDegree = std::numbers::pi_v<float> / 180;  // in radians

}  // namespace brindle::testing_support
