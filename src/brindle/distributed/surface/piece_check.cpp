#include "brindle/distributed/surface/piece_check.h"

#include <algorithm>
#include <cstdint>
#include <string>
#include <vector>

#include "brindle/error.h"
#include "brindle/surface.h"

namespace brindle {

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

}  // namespace brindle
