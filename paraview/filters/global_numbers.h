/// Identifies points that are one vertex, within and across ranks.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <brindle/types.h>

#include "ranks.h"

namespace brindle::paraview {

/// The points of a partition.
struct PiecePoints {
  std::span<const Vec3> positions;    ///< relative to an origin common to all ranks
  std::span<const std::int64_t> ids;  ///< global numbers, or empty
};

struct PointNumbers {
  std::vector<std::uint64_t> of_points;  ///< points with one number are one vertex
  bool by_id = false;  ///< whether numbers are ids; otherwise they follow from the points' order
  bool ids_refused = false;  ///< whether ids were rejected as global numbers
};

/// Collective. Points at exactly the same position are one vertex. If all points of all ranks have
/// ids, and each id belongs to one position up to rounding relative to `diagonal`, points with one
/// id are one vertex, too. A vertex has the lowest id of its points or, without ids, the index of
/// its first point over all ranks. Numbers, and what follows from them, do not depend on the
/// distribution of points.
PointNumbers global_numbers(const Ranks& ranks, const PiecePoints& points, double diagonal);

/// For every point, the first one of this rank with the same number.
std::vector<Index> first_points(std::span<const std::uint64_t> numbers);

/// Numbers of a partition's vertices, which are its points: the first of several points keeps the
/// number, the others get unique ones.
std::vector<std::uint64_t> vertex_numbers(const Ranks& ranks,
                                          std::span<const std::uint64_t> numbers,
                                          std::span<const Index> first);

}  // namespace brindle::paraview
