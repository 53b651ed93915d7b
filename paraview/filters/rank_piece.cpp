#include "rank_piece.h"

#include <algorithm>

namespace brindle::paraview {

RankPiece::RankPiece(const Ranks& ranks, const SurfacePiece& piece)
    : ranks_(ranks),
      vertex_ids_(piece.vertex_ids),
      ghosts_(piece.ghost_triangles),
      surface_(piece, ranks.communicator()),
      owners_(ranks, piece.vertex_ids, surface_.is_own()) {
  for (Index v = 0; v < piece.mesh.vertex_count(); ++v) sources_.push_back({ranks.rank(), v});
  owners_.from_owners(std::span(sources_));
}

bool RankPiece::is_shared_like(const RankPiece& other) const {
  return sources_ == other.sources_ && ghosts_ == other.ghosts_;
}

DataArray RankPiece::cells_to_points(const Mesh& mesh, const DataArray& rows) const {
  return brindle::cells_to_points(ranks_.messages(), {mesh, vertex_ids_, ghosts_}, rows);
}

std::array<double, 2> RankPiece::extent(std::array<double, 2> own) const {
  for (const auto& [lowest, highest] : ranks_.all(own)) {
    own = {std::min(own[0], lowest), std::max(own[1], highest)};
  }
  return own;
}

}  // namespace brindle::paraview
