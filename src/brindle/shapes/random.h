/// Random numbers that are the same on every machine and for every order of the calls.
#pragma once

#include <cstdint>

namespace brindle {

/// A number in [0, 1) for each pair of seed and place (SplitMix64: Steele, Lea and Flood 2014).
inline double random_number(std::uint64_t seed, std::uint64_t place) {
  std::uint64_t bits = seed * 0xd1342543de82ef95u + (place + 1) * 0x9e3779b97f4a7c15u;
  bits = (bits ^ (bits >> 30)) * 0xbf58476d1ce4e5b9u;
  bits = (bits ^ (bits >> 27)) * 0x94d049bb133111ebu;
  bits ^= bits >> 31;
  return static_cast<double>(bits >> 11) * 0x1.0p-53;
}

}  // namespace brindle
