#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "brindle/base/compressed_rows.h"
#include "brindle/base/memory.h"
#include "brindle/base/parallel.h"
#include "brindle/base/standard.h"
#include "brindle/error.h"
#include "brindle/points.h"
#include "brindle/points/point_tree.h"

namespace brindle {
namespace {

/// The `count` nearest other points of each used point.
std::vector<Index> nearest_others(std::span<const Vec3> positions, std::span<const Index> used,
                                  std::size_t count, const Progress& progress) {
  std::vector<Vec3> points;
  points.reserve(used.size());
  for (const Index i : used) points.push_back(positions[i]);
  const PointTree tree(points, progress.part(0, 0.2));
  std::vector<Index> nearest(used.size() * count);
  const auto find = [&](std::size_t begin, std::size_t end) {
    std::vector<Index> found;
    for (std::size_t i = begin; i < end; ++i) {
      // The result includes the point itself.
      tree.nearest(points[i], count + 1, found);
      std::size_t taken = 0;
      for (const Index other : found) {
        if (other != i && taken < count) nearest[i * count + taken++] = used[other];
      }
    }
  };
  constexpr std::size_t kGrain = 256;
  parallel_for(used.size(), progress.part(0.2, 1), find, kGrain);
  return nearest;
}

/// Symmetric rows: i's nearest points and those that i is nearest to. Unsorted, with duplicates.
CompressedRows<Index> joined_both_ways(std::span<const Index> used, std::span<const Index> nearest,
                                       std::size_t count, std::size_t points,
                                       const Progress& progress) {
  const auto add_all = [&](const Progress& part, const auto& add) {
    reported_for(nearest.size(), part, [&](std::size_t k) {
      const Index i = used[k / count], j = nearest[k];
      add(i, j);
      add(j, i);
    });
  };
  return compressed_rows<Index>(points, progress, add_all);
}

/// Sorts every row and removes duplicates.
Adjacency tidied(CompressedRows<Index> rows, const Progress& progress) {
  Adjacency result;
  result.offsets.assign(rows.size() + 1, 0);
  result.neighbors.reserve(rows.entries.size());
  reported_for(rows.size(), progress, [&](std::size_t i) {
    const std::span<Index> row = rows.of(i);
    ranges::sort(row);
    result.neighbors.insert(result.neighbors.end(), row.begin(),
                            std::unique(row.begin(), row.end()));
    result.offsets[i + 1] = static_cast<Index>(result.neighbors.size());
  });
  return result;
}

/// Throws TooLarge if memory cannot hold the neighbours found and the symmetric rows with and
/// without duplicates.
void check_room(std::size_t points, std::size_t others) {
  constexpr double kBytes = 5 * sizeof(Index);
  const auto count = static_cast<double>(points);
  check_fits(
      count * static_cast<double>(others), kBytes,
      std::to_string(others) + " neighbours of each of " + std::to_string(points) + " points",
      "neighbours", [&](double most) {
        return most < count ? std::string("take fewer points")
                            : rounded_down(std::floor(most / count)) + " each would do";
      });
}

}  // namespace

Adjacency point_neighborhood(std::span<const Vec3> positions, std::span<const Index> used,
                             int count, const Progress& progress) {
  if (count < 1) throw Error("points need at least one neighbour each");
  if (used.size() < 2) return {std::vector<Index>(positions.size() + 1, 0), {}};
  const std::size_t others = std::min(static_cast<std::size_t>(count), used.size() - 1);
  if (used.size() > 0xfffffffe / (2 * others)) {
    throw Error("there are too many points for this number of neighbours; take fewer of either");
  }
  check_room(used.size(), others);
  const std::vector<Index> nearest = nearest_others(positions, used, others, progress.part(0, 0.7));
  progress.report(0.7);
  CompressedRows<Index> rows =
      joined_both_ways(used, nearest, others, positions.size(), progress.part(0.7, 0.85));
  return tidied(std::move(rows), progress.part(0.85, 1));
}

}  // namespace brindle
