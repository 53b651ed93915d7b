/// Sines, angles, exponentials and logarithms that are bit-identical on every IEEE 754 machine.
/// They only use sums, products, quotients and roots, rounded one by one. C libraries select
/// implementations by processor (glibc: with or without fused multiply-adds), and differ. Doubles
/// are within 2.5 units in the last place, powers within as many as the integer part of their
/// logarithm. Floats are rounded from doubles, so they are nearly always exact.
#pragma once

#include <array>
#include <cmath>
#include <complex>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numbers>
#include <utility>

#include "brindle/base/standard.h"

namespace brindle {

/// A period, in radians.
inline constexpr float kTwoPi = 2 * std::numbers::pi_v<float>;

}  // namespace brindle

namespace brindle::elementary {

struct SineCosine {
  double sine;
  double cosine;
};

namespace detail {

/// pi / 2 in parts of 33 bits, so that products with numbers of up to 20 bits are exact, plus the
/// remainder.
inline constexpr double kQuarter[] = {0x1.921fb544p+0, 0x1.0b4611a6p-34, 0x1.3198a2e0p-69,
                                      0x1.b839a252049c1p-104};
inline constexpr double kPi = 0x1.921fb54442d18p+1, kPiRest = 0x1.1a62633145c07p-53;
/// log 2, of which the first part has 32 bits.
inline constexpr double kLog2 = 0x1.62e42feep-1, kLog2Rest = 0x1.a39ef35793c76p-33;

/// The nearest whole number, up to 2^51: the addition rounds off bits below 1.
constexpr double nearest_whole(double x) { return (x + 0x1.8p52) - 0x1.8p52; }

/// The series c[0] + c[1] x + c[2] x^2 + ...
template <class Real, std::size_t N>
constexpr Real series(const std::array<Real, N>& c, Real x) {
  Real sum = c[N - 1];
  for (std::size_t n = N - 1; n-- > 0;) sum = sum * x + c[n];
  return sum;
}

/// (-1)^n / (first + 2 n)!, for n = 0, 1, ...
template <std::size_t N>
constexpr std::array<double, N> alternating_factorials(int first) {
  std::array<double, N> c{};
  double factorial = 1;  // exact up to 18!, and 22! has 51 bits without its factors of 2
  for (int n = 2; n <= first; ++n) factorial *= n;
  for (std::size_t n = 0; n < N; ++n) {
    c[n] = (n % 2 == 0 ? 1 : -1) / factorial;
    factorial *= first + 1;
    factorial *= first + 2;
    first += 2;
  }
  return c;
}

/// Sine and cosine of a + rest, |a| at most slightly above pi / 4.
inline SineCosine of_small(double a, double rest) {
  constexpr auto kSine = alternating_factorials<8>(3), kCosine = alternating_factorials<8>(4);
  const double square = a * a, half = 0.5 * square;
  const double sine = a - (a * square * series(kSine, square) - rest * (1 - half));
  const double most = 1 - half;
  const double left = ((1 - most) - half) + (square * square * series(kCosine, square) - a * rest);
  return {sine, most + left};
}

/// atan(k / 8) in two parts, k = 0 to 8.
inline constexpr double kEighths[9][2] = {{0, 0},
                                          {0x1.fd5ba9aac2f6ep-4, -0x1.cd37686760c17p-59},
                                          {0x1.f5b75f92c80ddp-3, 0x1.8ab6e3cf7afbdp-57},
                                          {0x1.6f61941e4def1p-2, -0x1.c63aae6f6e918p-56},
                                          {0x1.dac670561bb4fp-2, 0x1.a2b7f222f65e2p-56},
                                          {0x1.1e00babdefeb4p-1, -0x1.928df287a668fp-58},
                                          {0x1.4978fa3269ee1p-1, 0x1.2419a87f2a458p-56},
                                          {0x1.700a7c5784634p-1, -0x1.8c34d25aadef6p-56},
                                          {0x1.921fb54442d18p-1, 0x1.1a62633145c07p-55}};

/// atan(small / large), 0 <= small <= large, both far from the ends of a double's range.
inline double angle_below_diagonal(double small, double large) {
  constexpr std::array<double, 8> kSeries = {-1.0 / 3,  1.0 / 5,  -1.0 / 7,  1.0 / 9,
                                             -1.0 / 11, 1.0 / 13, -1.0 / 15, 1.0 / 17};
  const double eighth = nearest_whole(8 * (small / large));
  const double slope = 0.125 * eighth;
  const double t = (small - slope * large) / (large + slope * small);
  const double square = t * t;
  const auto& known = kEighths[static_cast<std::size_t>(eighth)];
  return known[0] + (t + (t * square * series(kSeries, square) + known[1]));
}

}  // namespace detail

/// Beyond 10^6 radians, exact up to the rounding of the argument itself.
inline SineCosine sine_cosine(double radians) {
  using detail::kQuarter;
  if (std::abs(radians) > 1e6) radians = std::remainder(radians, 2 * detail::kPi);
  const double quarters = detail::nearest_whole(radians * (2 / detail::kPi));
  // The first difference is exact, the second one is a sum of two doubles.
  const double far = radians - quarters * kQuarter[0], taken = quarters * kQuarter[1];
  const double near = far - taken, back = near + taken;
  const double lost = (far - back) + (back - near - taken);
  const double rest = lost - quarters * kQuarter[2] - quarters * kQuarter[3];
  const double angle = near + rest;
  const SineCosine s = detail::of_small(angle, (near - angle) + rest);
  if (!(std::abs(quarters) <= 1e6)) return {radians - radians, radians - radians};
  switch (static_cast<int>(quarters) & 3) {
    case 0:
      return s;
    case 1:
      return {s.cosine, -s.sine};
    case 2:
      return {-s.sine, -s.cosine};
    default:
      return {-s.cosine, s.sine};
  }
}

inline double sin(double radians) { return radians == 0 ? radians : sine_cosine(radians).sine; }
inline double cos(double radians) { return sine_cosine(radians).cosine; }
inline double tan(double radians) {
  const SineCosine s = sine_cosine(radians);
  return s.sine / s.cosine;
}

inline double atan2(double y, double x) {
  double width = std::abs(x), height = std::abs(y);
  if (!(width >= 0 && height >= 0)) return x + y;
  const bool steep = width < height;
  if (std::isinf(width) && std::isinf(height)) width = height = 1;
  if (steep) std::swap(width, height);
  double angle = 0;
  if (height > 0 && !std::isinf(width)) {
    // Scaled so that products and sums neither overflow nor vanish.
    const double scale = width > 1e200 ? 0x1p-200 : width < 1e-200 ? 0x1p500 : 1.0;
    angle = detail::angle_below_diagonal(scale * height, scale * width);
  }
  if (steep) angle = 0.5 * detail::kPi - (angle - 0.5 * detail::kPiRest);
  if (std::signbit(x)) angle = detail::kPi - (angle - detail::kPiRest);
  return std::copysign(angle, y);
}

inline double exp(double x) {
  if (std::isnan(x) || x > 710) return x * std::numeric_limits<double>::infinity();
  if (x < -746) return 0;
  constexpr std::array<double, 12> kSeries = {
      1.0 / 2,     1.0 / 6,      1.0 / 24,      1.0 / 120,      1.0 / 720,       1.0 / 5040,
      1.0 / 40320, 1.0 / 362880, 1.0 / 3628800, 1.0 / 39916800, 1.0 / 479001600, 1.0 / 6227020800};
  const double doublings = detail::nearest_whole(x / (detail::kLog2 + detail::kLog2Rest));
  const double high = x - doublings * detail::kLog2, low = doublings * detail::kLog2Rest;
  const double r = high - low;
  const double power = 1 + (high - (low - r * r * detail::series(kSeries, r)));
  return std::ldexp(power, static_cast<int>(doublings));
}

inline double log(double x) {
  if (!(x > 0)) return x == 0 ? -std::numeric_limits<double>::infinity() : (x - x) / (x - x);
  if (std::isinf(x)) return x;
  constexpr std::array<double, 11> kSeries = {2.0 / 3,  2.0 / 5,  2.0 / 7,  2.0 / 9,
                                              2.0 / 11, 2.0 / 13, 2.0 / 15, 2.0 / 17,
                                              2.0 / 19, 2.0 / 21, 2.0 / 23};
  int doublings = 0;
  double part = std::frexp(x, &doublings);
  if (part < 0.70710678118654752) {
    part *= 2;
    --doublings;
  }
  // log(1 + f) = 2 atanh(s), s = f / (2 + f).
  const double f = part - 1, s = f / (2 + f), square = s * s;
  const double rest = square * detail::series(kSeries, square);
  const double left = s * (f - rest) - doublings * detail::kLog2Rest;
  return doublings * detail::kLog2 - (left - f);
}

/// NaN for negative bases with fractional exponents.
inline double pow(double base, double exponent) {
  if (exponent == 0) return 1;
  if (!(base < 0)) return exp(exponent * log(base));
  if (std::floor(exponent) != exponent) return std::numeric_limits<double>::quiet_NaN();
  const double size = exp(exponent * log(-base));
  return std::floor(0.5 * exponent) == 0.5 * exponent ? size : -size;
}

inline double cbrt(double x) {
  if (x == 0 || !std::isfinite(x)) return x;
  const double root = std::copysign(exp(log(std::abs(x)) / 3), x);
  return root - (root - x / (root * root)) / 3;  // one Newton step
}

inline float sin(float radians) { return static_cast<float>(sin(double{radians})); }
inline float cos(float radians) { return static_cast<float>(cos(double{radians})); }
inline float tan(float radians) { return static_cast<float>(tan(double{radians})); }
inline float atan2(float y, float x) { return static_cast<float>(atan2(double{y}, double{x})); }
inline float exp(float x) { return static_cast<float>(exp(double{x})); }

/// The same for exponents from -80 to 80, to two units in the last place. Without a branch, so that
/// compilers vectorise it.
inline float fast_exp(float x) {
  constexpr std::array<float, 6> kSeries = {1.0f / 2,   1.0f / 6,   1.0f / 24,
                                            1.0f / 120, 1.0f / 720, 1.0f / 5040};
  constexpr float kLog2 = 0x1.62ep-1f, kLog2Rest = 0x1.0bfbe8p-15f;  // the first has 12 bits
  constexpr float kWhole = 0x1.8p23f;                                // rounds off bits below 1
  const float doublings = (x * 1.44269504f + kWhole) - kWhole;
  const float r = (x - doublings * kLog2) - doublings * kLog2Rest;
  const float power = 1 + (r + r * r * detail::series(kSeries, r));
  return power * bit_cast<float>((static_cast<std::int32_t>(doublings) + 127) << 23);
}
inline float log(float x) { return static_cast<float>(log(double{x})); }
inline float pow(float base, float exponent) {
  return static_cast<float>(pow(double{base}, double{exponent}));
}

/// The angle of a complex number, in radians, -pi to pi.
template <class Real>
Real arg(const std::complex<Real>& z) {
  return atan2(z.imag(), z.real());
}

/// `length` exp(i `radians`).
template <class Real>
std::complex<Real> polar(Real length, Real radians) {
  const SineCosine s = sine_cosine(double{radians});
  return {length * static_cast<Real>(s.cosine), length * static_cast<Real>(s.sine)};
}

}  // namespace brindle::elementary
