/// Which points are one vertex, on one rank and on several.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <brindle/types.h>

#include "ranks.h"

namespace brindle::paraview {

/// The points of a piece.
struct PiecePoints {
  std::span<const Vec3> positions;    ///< about one origin on all ranks
  std::span<const std::int64_t> ids;  ///< their numbers in the whole, or none
};

struct PointNumbers {
  std::vector<std::uint64_t> of_points;  ///< points with the same number are one vertex
  bool by_id = false;        ///< whether numbers are ids; else they follow from the points' order
  bool ids_refused = false;  ///< whether there were ids that cannot be numbers in the whole
};

/// Collective. Points are one vertex if they stand at exactly the same place, and, where all points
/// of all ranks have ids and each belongs to one place of a whole whose diagonal is `diagonal`, but
/// for rounding, if they have the same id. A vertex has the lowest of its points' ids, or, without
/// ids, the number of its first point if those of all ranks are counted rank by rank. So numbers,
/// and what follows from them, do not depend on how many ranks share the points.
PointNumbers global_numbers(const Ranks& ranks, const PiecePoints& points, double diagonal);

/// For every point the first of this rank with the same number.
std::vector<Index> first_points(std::span<const std::uint64_t> numbers);

/// The numbers of a piece's vertices, which are its points: the first of those that are one has
/// their number, the others have some that no vertex of any rank has.
std::vector<std::uint64_t> vertex_numbers(const Ranks& ranks,
                                          std::span<const std::uint64_t> numbers,
                                          std::span<const Index> first);

}  // namespace brindle::paraview
