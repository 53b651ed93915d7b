/// What fuzzers feed with bytes, and what must hold whatever these are.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace brindle::fuzz {

/// What takes bytes: a reader of files of one format; "pattern", which makes a surface and frames
/// of a pattern; "operations", which does what a window can do.
struct Target {
  std::string_view name;
  void (*run)(const Target& target, std::span<const std::uint8_t> bytes);
};

std::span<const Target> targets();

/// Null if there is none of that name.
const Target* find_target(std::string_view name);

/// Lets a target take bytes and returns whether it did: what it refuses with an Error is fine.
/// Throws BrokenPromise for what must not be: an error without a word, numbers of vertices that are
/// none, an energy that is none, other bits in a second run, a state half changed by a cancelled
/// frame.
bool run(const Target& target, std::span<const std::uint8_t> bytes);

struct BrokenPromise {
  std::string what;
};

/// A few inputs that the target takes, to begin with.
std::vector<std::string> seeds(const Target& target);

}  // namespace brindle::fuzz
