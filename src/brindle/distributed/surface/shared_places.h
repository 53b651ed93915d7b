/// Vertices of several ranks, told by where they stand.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "brindle/communicator.h"
#include "brindle/types.h"

namespace brindle {

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
