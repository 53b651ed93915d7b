/// What the machine can gather at most: the yardstick of a sweep.
#pragma once

#include <cstdint>
#include <span>

#include "brindle/types.h"

namespace brindle::bench {

/// Reads z[j] for all j of `index` and does nothing but add their bits up, so that nothing can be
/// left out. Once with one load an element, once with vector gathers; which of the two is faster
/// differs from machine to machine.
std::uint64_t gather_portable(std::span<const Index> index, std::span<const Complex> z);
#ifdef BRINDLE_HAS_HIGHWAY
std::uint64_t gather_simd(std::span<const Index> index, std::span<const Complex> z);
#endif

}  // namespace brindle::bench
