/// Bob Jenkins's One-at-a-Time hash: pseudo-random numbers that depend only on a key.
#pragma once

#include <complex>
#include <cstdint>
#include <numbers>

#include "brindle/base/elementary.h"
#include "brindle/types.h"

namespace brindle {

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
