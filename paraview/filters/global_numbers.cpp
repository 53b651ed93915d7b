#include "global_numbers.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <numeric>
#include <unordered_map>
#include <utility>

#include <brindle/mesh.h>

namespace brindle::paraview {
namespace {

/// Coordinates closer than this, relative to the diagonal, may be one position, rounded.
constexpr double kRounding = 1e-5;

/// Numbers above belong to vertices that no other rank has.
constexpr std::uint64_t kUnshared = std::uint64_t{1} << 63;

/// The identity of points: a position or an id.
using Key = std::array<std::uint64_t, 2>;

Key key_of(const Vec3& position) {
  std::array<std::uint64_t, 3> bits;
  for (int k = 0; k < 3; ++k) {
    bits[static_cast<std::size_t>(k)] =
        std::bit_cast<std::uint32_t>(position[k] + 0.0f);  // -0 is 0
  }
  return {bits[0] << 32 | bits[1], bits[2]};
}

Key key_of(std::int64_t id) { return {static_cast<std::uint64_t>(id), 0}; }

struct Labelled {
  Key key;
  std::uint64_t label;

  auto operator<=>(const Labelled&) const = default;
};

/// For every requested point, the lowest label of all points with its key, list by list.
std::vector<std::vector<std::uint64_t>> lowest(const std::vector<std::vector<Labelled>>& asked) {
  std::vector<Labelled> known;
  for (const auto& list : asked) known.insert(known.end(), list.begin(), list.end());
  std::ranges::sort(known);
  std::vector<std::vector<std::uint64_t>> answers(asked.size());
  for (std::size_t r = 0; r < asked.size(); ++r) {
    for (const Labelled& point : asked[r]) {
      answers[r].push_back(std::ranges::lower_bound(known, point.key, {}, &Labelled::key)->label);
    }
  }
  return answers;
}

/// Collective. Gives every point the lowest label, over all ranks, of its key.
template <class Thing>
std::vector<std::uint64_t> lowest_labels(const Ranks& ranks, std::span<const Thing> things,
                                         std::span<const std::uint64_t> labels) {
  std::vector<Labelled> rows;
  for (std::size_t p = 0; p < things.size(); ++p) rows.push_back({key_of(things[p]), labels[p]});
  return answers_to(
      ranks, rows, [&](const Labelled& row) { return ranks.rank_of(row.key); }, lowest);
}

struct IdPlace {
  std::uint64_t id;
  std::array<float, 3> position;

  auto operator<=>(const IdPlace&) const = default;
};

bool near(const IdPlace& a, const IdPlace& b, double distance) {
  return (Vec3(a.position.data()) - Vec3(b.position.data())).cast<double>().norm() <= distance;
}

/// Collective. Whether every id belongs to one position.
bool ids_hold(const Ranks& ranks, const PiecePoints& points, double rounding) {
  std::vector<std::vector<IdPlace>> told(static_cast<std::size_t>(ranks.size()));
  for (std::size_t p = 0; p < points.ids.size(); ++p) {
    const auto id = static_cast<std::uint64_t>(points.ids[p]);
    const Vec3& at = points.positions[p];
    told[id % told.size()].push_back({id, {at.x(), at.y(), at.z()}});
  }
  std::vector<IdPlace> heard;
  for (const auto& list : ranks.swap_lists(told)) {
    heard.insert(heard.end(), list.begin(), list.end());
  }
  std::ranges::sort(heard);
  bool hold = true;
  for (std::size_t i = 1, first = 0; i < heard.size(); ++i) {
    if (heard[i].id != heard[first].id) first = i;
    hold = hold && near(heard[i], heard[first], rounding);
  }
  return ranks.every(hold);
}

/// Collective. Joins points with equal positions or ids, transitively.
std::vector<std::uint64_t> numbers_by_id(const Ranks& ranks, const PiecePoints& points) {
  std::vector<std::uint64_t> labels(points.ids.begin(), points.ids.end());
  while (true) {
    std::vector<std::uint64_t> next = lowest_labels(ranks, points.positions, labels);
    next = lowest_labels(ranks, points.ids, std::span<const std::uint64_t>(next));
    if (!ranks.any(next != labels)) return labels;
    labels = std::move(next);
  }
}

std::vector<std::uint64_t> numbers_by_place(const Ranks& ranks, std::span<const Vec3> positions) {
  if (ranks.alone()) {
    const std::vector<Index> first = first_at_each_place(positions);
    return {first.begin(), first.end()};
  }
  const std::vector<std::uint64_t> counts = ranks.all<std::uint64_t>(positions.size());
  std::vector<std::uint64_t> rows(positions.size());
  std::iota(rows.begin(), rows.end(),
            std::accumulate(counts.begin(), counts.begin() + ranks.rank(), std::uint64_t{0}));
  return lowest_labels(ranks, positions, std::span<const std::uint64_t>(rows));
}

}  // namespace

PointNumbers global_numbers(const Ranks& ranks, const PiecePoints& points, double diagonal) {
  const std::size_t count = points.positions.size();
  const bool any = ranks.any(!points.ids.empty());
  const bool all =
      ranks.every(count == 0 || (points.ids.size() == count && std::ranges::min(points.ids) >= 0));
  PointNumbers numbers;
  numbers.by_id = any && all && ids_hold(ranks, points, kRounding * diagonal);
  numbers.ids_refused = any && !numbers.by_id;
  numbers.of_points =
      numbers.by_id ? numbers_by_id(ranks, points) : numbers_by_place(ranks, points.positions);
  return numbers;
}

std::vector<Index> first_points(std::span<const std::uint64_t> numbers) {
  std::unordered_map<std::uint64_t, Index> first_with;
  first_with.reserve(numbers.size());
  std::vector<Index> first;
  for (Index p = 0; p < numbers.size(); ++p) {
    first.push_back(first_with.emplace(numbers[p], p).first->second);
  }
  return first;
}

std::vector<std::uint64_t> vertex_numbers(const Ranks& ranks,
                                          std::span<const std::uint64_t> numbers,
                                          std::span<const Index> first) {
  std::vector<std::uint64_t> result;
  for (Index p = 0; p < numbers.size(); ++p) {
    const auto here = static_cast<std::uint64_t>(ranks.rank());
    result.push_back(first[p] == p
                         ? numbers[p]
                         : kUnshared + p * static_cast<std::uint64_t>(ranks.size()) + here);
  }
  return result;
}

}  // namespace brindle::paraview
