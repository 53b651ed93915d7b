#include "brindle/distributed/surface/piece_check.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <string>
#include <tuple>
#include <vector>

#include "brindle/communicator.h"
#include "brindle/error.h"
#include "brindle/surface.h"

namespace brindle {
namespace {

/// The global numbers of a triangle's corners, ascending.
using CornerIds = std::array<std::uint64_t, 3>;

std::size_t rank_that_knows(const CornerIds& ids, std::size_t ranks) {
  std::uint64_t mixed = 0;
  for (const std::uint64_t id : ids) {
    mixed = (mixed ^ id) * 0x9e3779b97f4a7c15u;
    mixed ^= mixed >> 29;
  }
  return static_cast<std::size_t>(mixed % ranks);
}

/// Marks triangles that equal an earlier one in any list.
std::vector<std::vector<std::uint8_t>> are_repeated(
    const std::vector<std::vector<CornerIds>>& lists) {
  struct Mention {
    CornerIds ids;
    std::size_t list, row;
    auto key() const { return std::tie(ids, list, row); }
  };
  std::vector<Mention> known;
  std::vector<std::vector<std::uint8_t>> answers;
  for (std::size_t r = 0; r < lists.size(); ++r) {
    answers.emplace_back(lists[r].size());
    for (std::size_t i = 0; i < lists[r].size(); ++i) known.push_back({lists[r][i], r, i});
  }
  std::ranges::sort(known, {}, &Mention::key);
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
  std::vector<std::vector<CornerIds>> outgoing(static_cast<std::size_t>(ranks.size()));
  std::vector<std::size_t> knows;  // of own triangles
  const auto is_own = [&](std::size_t t) {
    return piece.ghost_triangles.empty() || piece.ghost_triangles[t] == 0;
  };
  for (std::size_t t = 0; t < piece.mesh.triangle_count(); ++t) {
    if (!is_own(t)) continue;
    CornerIds ids;
    for (std::size_t c = 0; c < 3; ++c) ids[c] = piece.vertex_ids[piece.mesh.triangles[t][c]];
    std::ranges::sort(ids);
    knows.push_back(rank_that_knows(ids, outgoing.size()));
    outgoing[knows.back()].push_back(ids);
  }
  const auto answers = ranks.swap_lists(are_repeated(ranks.swap_lists(outgoing)));
  std::vector<std::size_t> next(outgoing.size());
  std::vector<std::uint8_t> repeated(piece.mesh.triangle_count());
  for (std::size_t t = 0, own = 0; t < repeated.size(); ++t) {
    if (!is_own(t)) continue;
    const std::size_t rank = knows[own++];
    repeated[t] = answers[rank][next[rank]++];
  }
  return repeated;
}

}  // namespace brindle
