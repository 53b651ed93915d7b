#include "brindle/distributed/surface/shared_vertices.h"

#include <algorithm>
#include <array>
#include <bit>
#include <limits>
#include <tuple>
#include <utility>

namespace brindle {
namespace {

struct Mention {
  std::uint64_t id;
  std::uint64_t unused;  // 0 if a triangle uses it: used vertices take precedence
};

using Place = std::array<float, 3>;

/// Positive and negative zero are the same position.
Place place_of(const Vec3& p) { return {p.x() + 0.0f, p.y() + 0.0f, p.z() + 0.0f}; }

struct PlacedRow {
  Place place;
  std::uint64_t number;
};

std::size_t place_hash(const Place& place) {
  std::uint64_t mixed = 0;
  for (const float coordinate : place) {
    mixed = (mixed ^ std::bit_cast<std::uint32_t>(coordinate)) * 0x9e3779b97f4a7c15u;
    mixed ^= mixed >> 29;
  }
  return static_cast<std::size_t>(mixed);
}

/// For every row, the lowest number at its position, list by list.
std::vector<std::vector<std::uint64_t>> lowest_numbers(
    const std::vector<std::vector<PlacedRow>>& asked) {
  std::vector<std::pair<Place, std::uint64_t>> known;
  for (const auto& rows : asked) {
    for (const PlacedRow& row : rows) known.emplace_back(row.place, row.number);
  }
  std::ranges::sort(known);
  std::vector<std::vector<std::uint64_t>> answers(asked.size());
  for (std::size_t r = 0; r < asked.size(); ++r) {
    for (const PlacedRow& row : asked[r]) {
      answers[r].push_back(
          std::ranges::lower_bound(known, std::pair(row.place, std::uint64_t{0}))->second);
    }
  }
  return answers;
}

struct LabelledRow {
  std::uint64_t id;
  Place place;
  std::uint32_t label;

  auto key() const { return std::tuple(id, label); }
};

constexpr std::uint64_t kNoVertex = std::numeric_limits<std::uint64_t>::max();

TornVertex first_torn(std::span<const LabelledRow> sorted, float distance) {
  const auto far = [&](const Place& a, const Place& b) {
    return (Vec3(a.data()) - Vec3(b.data())).norm() > distance;
  };
  for (std::size_t row = 0, first = 0; row < sorted.size(); ++row) {
    if (sorted[row].id != sorted[first].id) first = row;
    if (far(sorted[first].place, sorted[row].place)) {
      return {sorted[row].id, sorted[first].label, sorted[row].label};
    }
  }
  return {kNoVertex, 0, 0};
}

}  // namespace

std::vector<int> find_owners(Communicator& ranks, std::span<const std::uint64_t> ids,
                             std::span<const std::uint8_t> used) {
  const auto size = static_cast<std::size_t>(ranks.size());
  if (size == 1) return std::vector<int>(ids.size(), 0);
  std::vector<std::vector<Mention>> mentions(size);
  for (std::size_t v = 0; v < ids.size(); ++v) {
    mentions[ids[v] % size].push_back({ids[v], used[v] ? 0u : 1u});
  }
  const auto asked = ranks.swap_lists(mentions);

  std::vector<std::tuple<std::uint64_t, std::uint64_t, int>> known;
  for (std::size_t r = 0; r < size; ++r) {
    for (const auto& [id, unused] : asked[r]) known.emplace_back(id, unused, static_cast<int>(r));
  }
  std::ranges::sort(known);
  std::vector<std::vector<int>> answers(size);
  for (std::size_t r = 0; r < size; ++r) {
    for (const Mention& mention : asked[r]) {
      const auto first = std::ranges::lower_bound(known, std::tuple(mention.id, 0ul, 0));
      answers[r].push_back(std::get<2>(*first));
    }
  }
  const auto owners = ranks.swap_lists(answers);

  std::vector<std::size_t> next(size);
  std::vector<int> owner;
  for (const std::uint64_t id : ids) owner.push_back(owners[id % size][next[id % size]++]);
  return owner;
}

std::vector<std::uint64_t> numbers_by_place(Communicator& ranks, std::span<const Vec3> positions) {
  const auto size = static_cast<std::size_t>(ranks.size());
  const std::vector<std::size_t> counts = ranks.all(positions.size());
  std::uint64_t first = 0;
  for (int r = 0; r < ranks.rank(); ++r) first += counts[static_cast<std::size_t>(r)];
  std::vector<std::vector<PlacedRow>> outgoing(size);
  for (std::size_t row = 0; row < positions.size(); ++row) {
    if (!positions[row].allFinite()) continue;
    const Place place = place_of(positions[row]);
    outgoing[place_hash(place) % size].push_back({place, first + row});
  }
  const auto answers = ranks.swap_lists(lowest_numbers(ranks.swap_lists(outgoing)));
  std::vector<std::size_t> next(size);
  std::vector<std::uint64_t> numbers;
  for (std::size_t row = 0; row < positions.size(); ++row) {
    if (!positions[row].allFinite()) {
      numbers.push_back(first + row);
      continue;
    }
    const std::size_t knows = place_hash(place_of(positions[row])) % size;
    numbers.push_back(answers[knows][next[knows]++]);
  }
  return numbers;
}

std::optional<TornVertex> find_torn_vertex(Communicator& ranks, std::span<const std::uint64_t> ids,
                                           std::span<const Vec3> positions,
                                           std::span<const std::uint32_t> labels, float distance) {
  const auto size = static_cast<std::size_t>(ranks.size());
  std::vector<std::vector<LabelledRow>> outgoing(size);
  for (std::size_t row = 0; row < ids.size(); ++row) {
    if (!positions[row].allFinite()) continue;
    outgoing[ids[row] % size].push_back({ids[row], place_of(positions[row]), labels[row]});
  }
  std::vector<LabelledRow> known;
  for (const auto& rows : ranks.swap_lists(outgoing))
    known.insert(known.end(), rows.begin(), rows.end());
  std::ranges::stable_sort(known, {}, &LabelledRow::key);
  const std::vector<TornVertex> torn = ranks.all(first_torn(known, distance));
  const TornVertex lowest = *std::ranges::min_element(torn, {}, &TornVertex::id);
  if (lowest.id == kNoVertex) return std::nullopt;
  return lowest;
}

}  // namespace brindle
