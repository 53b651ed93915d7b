#include "brindle/distributed/surface/shared_vertices.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <limits>
#include <string>
#include <tuple>
#include <unordered_map>
#include <utility>
#include <vector>

#include "brindle/communicator.h"
#include "brindle/error.h"
#include "brindle/surface.h"

namespace brindle {
namespace {

using Place = std::array<float, 3>;

/// Positive and negative zero are the same position.
Place place_of(const Vec3& p) { return {p.x() + 0.0f, p.y() + 0.0f, p.z() + 0.0f}; }

/// A hash of some bits.
std::size_t hash_of(std::span<const std::uint64_t> bits) {
  std::uint64_t mixed = 0;
  for (const std::uint64_t number : bits) {
    mixed = (mixed ^ number) * 0x9e3779b97f4a7c15u;
    mixed ^= mixed >> 29;
  }
  return static_cast<std::size_t>(mixed);
}

/// A row with a number, for `lowest_numbers`.
template <std::size_t N>
struct KeyedRow {
  std::array<std::uint64_t, N> key;
  std::uint64_t number;

  auto order() const { return std::tie(key, number); }
};

/// For every row, the lowest number of all ranks' rows with the same key.
template <std::size_t N>
std::vector<std::uint64_t> lowest_numbers(Communicator& ranks,
                                          const std::vector<KeyedRow<N>>& rows) {
  using Row = KeyedRow<N>;
  const auto size = static_cast<std::size_t>(ranks.size());
  const auto rank_of = [size](const Row& row) { return hash_of(row.key) % size; };
  return answers_to(ranks, rows, rank_of, [](const std::vector<std::vector<Row>>& asked) {
    std::vector<Row> known;
    for (const auto& list : asked) known.insert(known.end(), list.begin(), list.end());
    std::ranges::sort(known, {}, &Row::order);
    std::vector<std::vector<std::uint64_t>> answers(asked.size());
    for (std::size_t r = 0; r < asked.size(); ++r) {
      for (const Row& row : asked[r]) {
        answers[r].push_back(std::ranges::lower_bound(known, row.key, {}, &Row::key)->number);
      }
    }
    return answers;
  });
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
  std::vector<KeyedRow<1>> mentions;  // used vertices take precedence
  for (std::size_t v = 0; v < ids.size(); ++v) {
    mentions.push_back({{ids[v]}, (used[v] ? 0 : size) + static_cast<std::size_t>(ranks.rank())});
  }
  std::vector<int> owners;
  for (const std::uint64_t number : lowest_numbers(ranks, mentions)) {
    owners.push_back(static_cast<int>(number % size));
  }
  return owners;
}

std::vector<std::vector<Index>> hear_of_triangles(Communicator& ranks, SurfacePiece& piece,
                                                  std::vector<int>& owner) {
  struct SentTriangle {
    std::uint64_t number;  // global
    std::array<std::uint64_t, 3> id;
    std::array<int, 3> owner;
    std::array<Place, 3> position;
  };
  std::vector<std::vector<SentTriangle>> outgoing(static_cast<std::size_t>(ranks.size()));
  std::vector<std::vector<Index>> told(outgoing.size());
  for (Index t = 0; t < piece.mesh.triangle_count(); ++t) {
    SentTriangle triangle{piece.triangle_ids[t], {}, {}, {}};
    for (std::size_t c = 0; c < 3; ++c) {
      const Index v = piece.mesh.triangles[t][c];
      const Vec3& p = piece.mesh.positions[v];
      triangle.id[c] = piece.vertex_ids[v];
      triangle.owner[c] = owner[v];
      triangle.position[c] = {p.x(), p.y(), p.z()};
    }
    const auto& owners = triangle.owner;
    for (std::size_t c = 0; c < 3; ++c) {
      const bool again = (c > 0 && owners[c] == owners[0]) || (c > 1 && owners[c] == owners[1]);
      if (owners[c] == ranks.rank() || again) continue;
      outgoing[static_cast<std::size_t>(owners[c])].push_back(triangle);
      told[static_cast<std::size_t>(owners[c])].push_back(t);
    }
  }
  std::unordered_map<std::uint64_t, Index> vertex_of;
  for (Index v = 0; v < piece.vertex_ids.size(); ++v) vertex_of[piece.vertex_ids[v]] = v;
  for (const auto& from_rank : ranks.swap_lists(outgoing)) {
    for (const SentTriangle& triangle : from_rank) {
      Triangle& corners = piece.mesh.triangles.emplace_back();
      piece.triangle_ids.push_back(triangle.number);
      for (std::size_t c = 0; c < 3; ++c) {
        const auto next = static_cast<Index>(owner.size());
        const auto [place, is_new] = vertex_of.emplace(triangle.id[c], next);
        corners[c] = place->second;
        if (!is_new) continue;
        const auto& [x, y, z] = triangle.position[c];
        piece.mesh.positions.emplace_back(x, y, z);
        piece.vertex_ids.push_back(triangle.id[c]);
        owner.push_back(triangle.owner[c]);
      }
    }
  }
  return told;
}

std::vector<std::uint64_t> numbers_by_place(Communicator& ranks, std::span<const Vec3> positions) {
  std::vector<std::uint64_t> numbers = ranks.numbers_of(positions.size());
  std::vector<KeyedRow<3>> placed;
  for (std::size_t row = 0; row < positions.size(); ++row) {
    if (!positions[row].allFinite()) continue;
    KeyedRow<3>& made = placed.emplace_back();
    made.number = numbers[row];
    std::ranges::transform(place_of(positions[row]), made.key.begin(),
                           [](float x) { return std::bit_cast<std::uint32_t>(x); });
  }
  const std::vector<std::uint64_t> lowest = lowest_numbers(ranks, placed);
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
  std::vector<KeyedRow<3>> own;        // the global numbers of a triangle's corners, ascending
  std::vector<std::size_t> triangles;  // of `own`
  for (std::size_t t = 0; t < piece.mesh.triangle_count(); ++t) {
    if (!piece.ghost_triangles.empty() && piece.ghost_triangles[t] != 0) continue;
    auto& ids = own.emplace_back().key;
    for (std::size_t c = 0; c < 3; ++c) ids[c] = piece.vertex_ids[piece.mesh.triangles[t][c]];
    std::ranges::sort(ids);
    triangles.push_back(t);
  }
  const std::vector<std::uint64_t> numbers = ranks.numbers_of(own.size());
  for (std::size_t i = 0; i < own.size(); ++i) own[i].number = numbers[i];
  const std::vector<std::uint64_t> lowest = lowest_numbers(ranks, own);
  std::vector<std::uint8_t> repeated(piece.mesh.triangle_count());
  for (std::size_t i = 0; i < own.size(); ++i) repeated[triangles[i]] = lowest[i] != numbers[i];
  return repeated;
}

}  // namespace brindle
