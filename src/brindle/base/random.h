/// Random numbers that are the same on every machine and for any order of calls.
#pragma once

#include <cstdint>

namespace brindle {

/// A pseudo-random number for every number, without collisions: the finaliser of SplitMix64
/// (Steele, Lea and Flood 2014).
constexpr std::uint64_t mixed_bits(std::uint64_t bits) {
  bits = (bits ^ (bits >> 30)) * 0xbf58476d1ce4e5b9u;
  bits = (bits ^ (bits >> 27)) * 0x94d049bb133111ebu;
  return bits ^ (bits >> 31);
}

/// The increment of SplitMix64.
inline constexpr std::uint64_t kRandomStep = 0x9e3779b97f4a7c15u;

/// A pseudo-random number in [0, 1) for each pair of seed and place.
constexpr double random_number(std::uint64_t seed, std::uint64_t place) {
  const std::uint64_t bits = mixed_bits(seed * 0xd1342543de82ef95u + (place + 1) * kRandomStep);
  return static_cast<double>(bits >> 11) * 0x1.0p-53;
}

}  // namespace brindle
