// Creases of a distributed surface, found by rank 0.
#include <algorithm>
#include <cstdint>
#include <limits>
#include <string>

#include "brindle/distributed/surface/gathered_surface.h"
#include "brindle/distributed_surface.h"
#include "brindle/error.h"
#include "brindle/geometry/crease_edges.h"

namespace brindle {
namespace {

/// A corner of a partition that is moved to a copy of its vertex.
struct MovedCorner {
  Index triangle;
  Index corner;
  std::uint64_t copy;  ///< its number
};

/// The number of the first copy.
std::uint64_t first_copy(std::uint64_t last_number) {
  constexpr std::uint64_t kMost = ~std::uint64_t{std::numeric_limits<Index>::max()};
  if (last_number < kMost) return last_number + 1;
  throw Error("a vertex has the number " + std::to_string(last_number) +
              "; to split a surface at creases its numbers must be below 2^64 - 2^32 (an angle of "
              "180 degrees leaves creases out)");
}

/// On rank 0, for all ranks: the corners that differ in the split mesh, sorted by copies.
std::vector<std::vector<MovedCorner>> moved_corners(const GatheredSurface& whole, const Mesh& split,
                                                    std::span<const TriangleOfPiece> triangles,
                                                    std::size_t ranks) {
  std::vector<std::vector<MovedCorner>> moved(ranks);
  const Mesh& mesh = whole.surface().mesh;
  const std::uint64_t first = first_copy(whole.ids().back());
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    for (Index c = 0; c < 3; ++c) {
      const Index vertex = split.triangles[t][c];
      if (vertex < mesh.vertex_count()) continue;
      moved[static_cast<std::size_t>(triangles[t].rank)].push_back(
          {triangles[t].triangle, c, first + (vertex - mesh.vertex_count())});
    }
  }
  for (auto& corners : moved) std::ranges::stable_sort(corners, {}, &MovedCorner::copy);
  return moved;
}

/// Returns the vertices that added ones copy.
std::vector<Index> move_corners(const std::vector<MovedCorner>& moved, SurfacePiece& piece) {
  std::vector<Index> copied;
  const std::size_t own = piece.vertex_ids.size();
  for (const auto& [triangle, c, copy] : moved) {
    Index& corner = piece.mesh.triangles[triangle][c];
    // Corners are sorted by copies.
    if (copied.empty() || piece.vertex_ids.back() != copy) {
      copied.push_back(corner);
      piece.vertex_ids.push_back(copy);
      piece.mesh.positions.push_back(Vec3(piece.mesh.positions[corner]));
    }
    corner = static_cast<Index>(own + copied.size() - 1);
  }
  return copied;
}

}  // namespace

std::optional<std::vector<Index>> split_at_creases(const DistributedSurface& surface,
                                                   SurfacePiece& piece, float angle_deg) {
  const RankSurface& own = surface.rank_surface();
  Communicator& ranks = *own.ranks;
  bool may_split = false;
  ranks.throw_on_all([&] { may_split = may_have_creases(triangles_around_own(own), angle_deg); });
  if (!ranks.any(may_split)) return std::nullopt;
  const GatheredSurface whole(own);
  const std::vector<TriangleOfPiece> triangles = whole.triangles_of_pieces();
  const auto size = static_cast<std::size_t>(ranks.size());
  std::vector<std::vector<MovedCorner>> moved(size);
  ranks.throw_on_all([&] {
    if (!whole.is_first()) return;
    Mesh split = whole.surface().mesh;
    piece.creases = split_at_creases(split, angle_deg);
    if (!piece.creases.empty()) moved = moved_corners(whole, split, triangles, size);
  });
  if (!ranks.any(!piece.creases.empty())) return std::nullopt;
  return move_corners(ranks.swap_lists(moved)[0], piece);
}

}  // namespace brindle
