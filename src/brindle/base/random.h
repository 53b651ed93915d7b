/// Random numbers that are the same on every machine and for any order of calls.
#pragma once

#include <complex>
#include <cstdint>
#include <numbers>

#include "brindle/base/elementary.h"
#include "brindle/types.h"

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

// Bob Jenkins's One-at-a-Time hash: pseudo-random numbers that depend only on a key.

/// The hash of the number's four bytes, least significant first.
constexpr std::uint32_t jenkins_hash(std::uint32_t key) {
  std::uint32_t hash = 0;
  for (int byte = 0; byte < 4; ++byte) {
    hash += (key >> (8 * byte)) & 0xffu;
    hash += hash << 10;
    hash ^= hash >> 6;
  }
  hash += hash << 3;
  hash ^= hash >> 11;
  return hash + (hash << 15);
}

/// The paper's pseudo-random start (3.2): exp(i Phi), Phi in [0, 2 pi) hashed from the node number.
inline Complex random_phase(Index node, std::uint32_t seed = 0) {
  const double turns = jenkins_hash(node + seed) / 4294967296.0;
  const auto radians = static_cast<float>(2 * std::numbers::pi * turns);
  return elementary::polar(1.0f, radians);
}

}  // namespace brindle
