/// Which vertices of several ranks are one.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <brindle/types.h>

#include "ranks.h"

namespace brindle::paraview {

/// The vertices of a piece.
struct PieceVertices {
  std::span<const Vec3> positions;    ///< about one origin on all ranks
  std::span<const Index> first;       ///< `first_at_each_place`
  std::span<const std::int64_t> ids;  ///< their numbers in the whole, or none
};

/// Collective. A number for every vertex, the same for those of several ranks that stand at exactly
/// the same place, or have the same id, where all ranks with vertices have ids and each belongs to
/// one place of a whole whose diagonal is `diagonal`, but for rounding. Of vertices of one rank at
/// one place the first has that number; the others have numbers of their own.
std::vector<std::uint64_t> global_numbers(const Ranks& ranks, const PieceVertices& vertices,
                                          double diagonal);

}  // namespace brindle::paraview
