/// Who owns a vertex that several ranks have.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "brindle/communicator.h"

namespace brindle {

/// For every number the lowest rank that has it with `used` set, or, if none does, the lowest that
/// has it at all. Rank (number mod ranks) knows.
std::vector<int> find_owners(Communicator& ranks, std::span<const std::uint64_t> ids,
                             std::span<const std::uint8_t> used);

}  // namespace brindle
