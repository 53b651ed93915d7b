#include "brindle/base/elementary.h"

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>

#include <gtest/gtest.h>

#include "test_numbers.h"

namespace brindle {
namespace {

using testing_support::kInfinity;
using testing_support::kNaN;

/// How far a double is from a more exact number, in units in its last place.
double units_off(double got, long double exact) {
  const auto nearest = static_cast<double>(exact);
  const double unit = std::nextafter(std::abs(nearest), kInfinity) - std::abs(nearest);
  return static_cast<double>(std::abs(got - exact) / unit);
}

/// Numbers of all sizes up to 2^`exponent`, of both signs.
class RandomNumbers {
 public:
  explicit RandomNumbers(int exponent) : exponent_(exponent) {}
  double operator()() {
    std::uniform_real_distribution<double> unit(-1, 1);
    return unit(random_) * std::ldexp(1.0, static_cast<int>(exponent_ * unit(random_)));
  }

 private:
  int exponent_;
  std::mt19937 random_{1};
};

TEST(Elementary, SinesAndAnglesAreExactToTheLastPlaces) {
  RandomNumbers number(19);
  for (int n = 0; n < 100000; ++n) {
    const double x = number(), y = number();
    ASSERT_LT(units_off(elementary::sin(x), std::sin(static_cast<long double>(x))), 1.5) << x;
    ASSERT_LT(units_off(elementary::cos(x), std::cos(static_cast<long double>(x))), 1.5) << x;
    ASSERT_LT(units_off(elementary::tan(x), std::tan(static_cast<long double>(x))), 2.5) << x;
    ASSERT_LT(units_off(elementary::atan2(y, x), std::atan2(static_cast<long double>(y), x)), 1.5)
        << y << ' ' << x;
  }
}

TEST(Elementary, SinesNearTheirZerosAreAsExact) {
  for (int n = 1; n < 600000; n = n + 1 + n / 50) {
    const double x = n * 1.5707963267948966;
    ASSERT_LT(units_off(elementary::sin(x), std::sin(static_cast<long double>(x))), 1.5) << x;
    ASSERT_LT(units_off(elementary::cos(x), std::cos(static_cast<long double>(x))), 1.5) << x;
  }
}

TEST(Elementary, FarAnglesAreWithinTheirOwnRounding) {
  for (double x = 1.1e6; x < 1e15; x *= 1.37) {
    const double unit = std::nextafter(x, kInfinity) - x;
    EXPECT_LT(std::abs(elementary::sin(x) - std::sin(static_cast<long double>(x))), unit) << x;
  }
}

TEST(Elementary, PowersAndLogarithmsAreExactToTheLastPlaces) {
  RandomNumbers number(9), size(900);
  for (int n = 0; n < 100000; ++n) {
    const double x = number(), y = std::abs(size());
    if (std::abs(x) > 700) continue;
    ASSERT_LT(units_off(elementary::exp(x), std::exp(static_cast<long double>(x))), 1.5) << x;
    ASSERT_LT(units_off(elementary::log(y), std::log(static_cast<long double>(y))), 1.5) << y;
    const double power = elementary::pow(y, x / 700);
    ASSERT_NEAR(power / std::pow(y, x / 700), 1, 1e-12) << y << ' ' << x;
    ASSERT_LT(units_off(elementary::cbrt(-y), std::cbrt(-static_cast<long double>(y))), 2.5) << y;
  }
}

TEST(Elementary, FastPowersAreExactToTwoUnitsOfAFloat) {
  for (float x = -80; x <= 80; x += 0.00097f) {
    const long double exact = std::exp(static_cast<long double>(x));
    const float nearest = static_cast<float>(exact);
    const float unit = std::nextafter(nearest, std::numeric_limits<float>::infinity()) - nearest;
    ASSERT_LT(std::abs(elementary::fast_exp(x) - exact), 2 * static_cast<long double>(unit)) << x;
  }
  EXPECT_EQ(elementary::fast_exp(0), 1);
}

TEST(Elementary, EndsAreThoseOfTheStandardLibrary) {
  const double numbers[] = {0.0,    -0.0,   1.0,       -1.0,       1e308,
                            -1e308, 1e-320, kInfinity, -kInfinity, kNaN};
  const auto expect_same = [](double a, double b) {
    if (std::isnan(b)) {
      EXPECT_TRUE(std::isnan(a)) << a;
    } else {
      EXPECT_DOUBLE_EQ(a, b);
      EXPECT_EQ(std::signbit(a), std::signbit(b)) << a << ' ' << b;
    }
  };
  for (const double x : numbers) {
    if (std::abs(x) < 1e300 || !std::isfinite(x)) {
      expect_same(elementary::sin(x), std::sin(x));
      expect_same(elementary::cos(x), std::cos(x));
    }
    expect_same(elementary::exp(x), std::exp(x));
    expect_same(elementary::log(x), std::log(x));
    expect_same(elementary::cbrt(x), std::cbrt(x));
    for (const double y : numbers) expect_same(elementary::atan2(y, x), std::atan2(y, x));
  }
  for (const double x : std::initializer_list<double>{0, 1, -1, kInfinity, kNaN}) {
    for (const double y : {0.0, 0.5, 2.0, 3.0, -1.0}) {
      expect_same(elementary::pow(x, y), std::pow(x, y));
    }
  }
}

TEST(Elementary, PolarAndArgUndoEachOther) {
  for (float angle = -3.14f; angle < 3.14f; angle += 0.01f) {
    EXPECT_NEAR(elementary::arg(elementary::polar(2.0f, angle)), angle, 3e-7f);
    EXPECT_EQ(elementary::polar(1.0f, angle).imag(), elementary::sin(angle));
    EXPECT_EQ(elementary::polar(1.0f, angle).real(), elementary::cos(angle));
  }
}

/// Every machine must find these bits.
TEST(Elementary, BitsAreTheSameEverywhere) {
  std::uint64_t bits = 0;
  const auto add = [&](double value) { bits = bits * 31 + std::bit_cast<std::uint64_t>(value); };
  std::uint64_t state = 1;
  for (int n = 0; n < 20000; ++n) {
    state = state * 6364136223846793005u + 1442695040888963407u;
    const double x = (static_cast<double>(state >> 11) * 0x1p-53 - 0.5) * 100;
    add(elementary::sin(x));
    add(elementary::cos(x));
    add(elementary::atan2(x, 3.0));
    add(elementary::exp(x));
    add(elementary::log(std::abs(x)));
  }
  EXPECT_EQ(bits, 18231111884320255594u);
}

}  // namespace
}  // namespace brindle
