/// Vertices that several ranks have, told by their numbers or by where they stand.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "brindle/communicator.h"
#include "brindle/types.h"

namespace brindle {

// All of these must be called by all ranks.

/// For every number the lowest rank that has it with `used` set, or, if none does, the lowest that
/// has it at all.
std::vector<int> find_owners(Communicator& ranks, std::span<const std::uint64_t> ids,
                             std::span<const std::uint8_t> used);

/// Numbers for rows that have none: rows are counted rank by rank, and each has the number of the
/// first row of all ranks at exactly its place. Places that are not finite are each their own.
std::vector<std::uint64_t> numbers_by_place(Communicator& ranks, std::span<const Vec3> positions);

/// Two rows of one number that are farther from each other than they may be.
struct TornVertex {
  std::uint64_t id;
  std::uint32_t label, other_label;
};

/// The torn vertex of the lowest number that some rank knows of, on all ranks; nothing if rows of
/// one number are never farther apart than `distance`. `labels` says of every row what a message
/// would call it by. Rows that are not finite do not count.
std::optional<TornVertex> find_torn_vertex(Communicator& ranks, std::span<const std::uint64_t> ids,
                                           std::span<const Vec3> positions,
                                           std::span<const std::uint32_t> labels, float distance);

}  // namespace brindle
