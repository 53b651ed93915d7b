/// Vertices shared by ranks, identified by number or position.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "brindle/communicator.h"
#include "brindle/distributed_surface.h"
#include "brindle/types.h"

namespace brindle {

// All of these are collective.

/// The owner of every number: the lowest rank that has it with `used` set or, without any, the
/// lowest that has it.
std::vector<int> find_owners(Communicator& ranks, std::span<const std::uint64_t> ids,
                             std::span<const std::uint8_t> used);

/// Sends all triangles, which need numbers, to the other owners of their vertices, and appends the
/// received ones with their vertices and owners. Returns the triangles sent to each rank.
std::vector<std::vector<Index>> hear_of_triangles(Communicator& ranks, SurfacePiece& piece,
                                                  std::vector<int>& owner);

/// Numbers for rows without: the index, over all ranks, of the first row at exactly the same
/// position. Rows with positions that are not finite are distinct.
std::vector<std::uint64_t> numbers_by_place(Communicator& ranks, std::span<const Vec3> positions);

/// Two rows of one number that are too far apart.
struct TornVertex {
  std::uint64_t id;
  std::uint32_t label, other_label;
};

/// The torn vertex with the lowest number on any rank, on all ranks; empty if rows of one number
/// are within `distance`. `labels` names rows in messages. Ignores rows that are not finite.
std::optional<TornVertex> find_torn_vertex(Communicator& ranks, std::span<const std::uint64_t> ids,
                                           std::span<const Vec3> positions,
                                           std::span<const std::uint32_t> labels, float distance);

// Validates partitions.

/// Throws Error for inconsistent lists, as `make_surface` does for meshes, and for repeated vertex
/// numbers. Checks one rank only.
void check_piece(const SurfacePiece& piece);

}  // namespace brindle
