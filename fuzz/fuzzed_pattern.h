/// Surfaces and requests that bytes describe.
#pragma once

#include <cstdint>
#include <span>

namespace brindle::fuzz {

/// Makes a mesh, a field and options of the bytes, solves, goes on for a few frames, and cancels
/// one of them. Throws Error for what is refused, and BrokenPromise.
void run_pattern(std::span<const std::uint8_t> bytes);

}  // namespace brindle::fuzz
