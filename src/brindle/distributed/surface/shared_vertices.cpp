#include "brindle/distributed/surface/shared_vertices.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <limits>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "brindle/communicator.h"
#include "brindle/error.h"
#include "brindle/surface.h"

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

/// A hash of some bits.
std::size_t hash_of(std::span<const std::uint64_t> bits) {
  std::uint64_t mixed = 0;
  for (const std::uint64_t number : bits) {
    mixed = (mixed ^ number) * 0x9e3779b97f4a7c15u;
    mixed ^= mixed >> 29;
  }
  return static_cast<std::size_t>(mixed);
}

std::size_t place_hash(const Place& place) {
  std::array<std::uint64_t, 3> bits;
  std::ranges::transform(place, bits.begin(),
                         [](float x) { return std::bit_cast<std::uint32_t>(x); });
  return hash_of(bits);
}

/// The rank that owns each number, list by list.
std::vector<std::vector<int>> first_ranks(const std::vector<std::vector<Mention>>& asked) {
  std::vector<std::tuple<std::uint64_t, std::uint64_t, int>> known;
  for (std::size_t r = 0; r < asked.size(); ++r) {
    for (const auto& [id, unused] : asked[r]) known.emplace_back(id, unused, static_cast<int>(r));
  }
  std::ranges::sort(known);
  std::vector<std::vector<int>> answers(asked.size());
  for (std::size_t r = 0; r < asked.size(); ++r) {
    for (const Mention& mention : asked[r]) {
      const auto first = std::ranges::lower_bound(known, std::tuple(mention.id, 0ul, 0));
      answers[r].push_back(std::get<2>(*first));
    }
  }
  return answers;
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
  std::vector<Mention> mentions;
  for (std::size_t v = 0; v < ids.size(); ++v) mentions.push_back({ids[v], used[v] ? 0u : 1u});
  return answers_to(
      ranks, mentions, [&](const Mention& mention) { return mention.id % size; }, first_ranks);
}

std::vector<std::uint64_t> numbers_by_place(Communicator& ranks, std::span<const Vec3> positions) {
  const auto size = static_cast<std::size_t>(ranks.size());
  std::vector<std::uint64_t> numbers = ranks.numbers_of(positions.size());
  std::vector<PlacedRow> placed;
  for (std::size_t row = 0; row < positions.size(); ++row) {
    if (positions[row].allFinite()) placed.push_back({place_of(positions[row]), numbers[row]});
  }
  const std::vector<std::uint64_t> lowest = answers_to(
      ranks, placed, [&](const PlacedRow& row) { return place_hash(row.place) % size; },
      lowest_numbers);
  for (std::size_t row = 0, next = 0; row < positions.size(); ++row) {
    if (positions[row].allFinite()) numbers[row] = lowest[next++];
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

namespace {

/// The global numbers of a triangle's corners, ascending.
using CornerIds = std::array<std::uint64_t, 3>;

/// Marks triangles that equal an earlier one in any list.
std::vector<std::vector<std::uint8_t>> are_repeated(
    const std::vector<std::vector<CornerIds>>& lists) {
  struct Sent {
    CornerIds ids;
    std::size_t list, row;
    auto key() const { return std::tie(ids, list, row); }
  };
  std::vector<Sent> known;
  std::vector<std::vector<std::uint8_t>> answers;
  for (std::size_t r = 0; r < lists.size(); ++r) {
    answers.emplace_back(lists[r].size());
    for (std::size_t i = 0; i < lists[r].size(); ++i) known.push_back({lists[r][i], r, i});
  }
  std::ranges::sort(known, {}, &Sent::key);
  for (std::size_t k = 1; k < known.size(); ++k) {
    if (known[k].ids == known[k - 1].ids) answers[known[k].list][known[k].row] = 1;
  }
  return answers;
}

}  // namespace

void check_piece(const SurfacePiece& piece) {
  check_mesh(piece.mesh);
  if (piece.vertex_ids.size() != piece.mesh.vertex_count()) {
    throw Error("a piece of " + std::to_string(piece.mesh.vertex_count()) + " vertices has " +
                std::to_string(piece.vertex_ids.size()) + " vertex numbers; give one for each");
  }
  if (!piece.ghost_triangles.empty() &&
      piece.ghost_triangles.size() != piece.mesh.triangle_count()) {
    throw Error("a piece of " + std::to_string(piece.mesh.triangle_count()) +
                " triangles says of " + std::to_string(piece.ghost_triangles.size()) +
                " whether they are ghosts; say it of each or of none");
  }
  if (!piece.triangle_ids.empty() && piece.triangle_ids.size() != piece.mesh.triangle_count()) {
    throw Error("a piece of " + std::to_string(piece.mesh.triangle_count()) + " triangles has " +
                std::to_string(piece.triangle_ids.size()) +
                " triangle numbers; give one for each, or none");
  }
  std::vector<std::uint64_t> ids = piece.vertex_ids;
  std::ranges::sort(ids);
  const auto twice = std::ranges::adjacent_find(ids);
  if (twice == ids.end()) return;
  throw Error("two vertices of a piece have the number " + std::to_string(*twice) +
              "; join them, or give each its own");
}

std::vector<std::uint8_t> repeated_triangles(const SurfacePiece& piece, MPI_Comm communicator) {
  Communicator ranks(communicator);
  ranks.throw_on_all([&] { check_piece(piece); });
  std::vector<CornerIds> own;
  std::vector<std::size_t> triangles;  // of `own`
  for (std::size_t t = 0; t < piece.mesh.triangle_count(); ++t) {
    if (!piece.ghost_triangles.empty() && piece.ghost_triangles[t] != 0) continue;
    CornerIds& ids = own.emplace_back();
    for (std::size_t c = 0; c < 3; ++c) ids[c] = piece.vertex_ids[piece.mesh.triangles[t][c]];
    std::ranges::sort(ids);
    triangles.push_back(t);
  }
  const auto size = static_cast<std::size_t>(ranks.size());
  const std::vector<std::uint8_t> answers = answers_to(
      ranks, own, [&](const CornerIds& ids) { return hash_of(ids) % size; }, are_repeated);
  std::vector<std::uint8_t> repeated(piece.mesh.triangle_count());
  for (std::size_t i = 0; i < own.size(); ++i) repeated[triangles[i]] = answers[i];
  return repeated;
}

}  // namespace brindle
