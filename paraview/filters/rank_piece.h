/// One rank's partition of a distributed surface.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include <brindle/data_arrays.h>
#include <brindle/distributed_pattern.h>
#include <brindle/distributed_surface.h>
#include <brindle/mesh.h>
#include <brindle/stripe_pattern.h>

#include "owner_exchange.h"
#include "ranks.h"

namespace brindle::paraview {

/// The constructor is collective, and functions that say so.
class RankPiece {
 public:
  RankPiece(const Ranks& ranks, const SurfacePiece& piece);

  const Ranks& ranks() const { return ranks_; }
  const DistributedSurface& surface() const { return surface_; }
  const OwnerExchange& owners() const { return owners_; }
  /// One per triangle: 1 for ghosts.
  std::span<const std::uint8_t> ghosts() const { return ghosts_; }

  /// A pattern of this partition in the library's form; refers to both.
  PiecePattern part_of(const StripePattern& pattern) const {
    return {surface_, pattern.waves, pattern.solution.z, pattern.phase_shift};
  }

  /// Whether owners of vertices and ghost triangles are the same.
  bool is_shared_like(const RankPiece& other) const;

  /// Collective. The library's `cells_to_points`, over own triangles of all ranks.
  DataArray cells_to_points(const Mesh& mesh, const DataArray& rows) const;

  /// Collective. The smallest and largest number over all ranks; the first is above the second if
  /// none has any.
  std::array<double, 2> extent(std::array<double, 2> own) const;

 private:
  /// A vertex on its owner.
  struct Source {
    int rank;
    Index vertex;
    bool operator==(const Source&) const = default;
  };

  Ranks ranks_;
  std::vector<std::uint64_t> vertex_ids_;
  std::vector<std::uint8_t> ghosts_;
  DistributedSurface surface_;
  OwnerExchange owners_;
  std::vector<Source> sources_;  ///< per vertex
};

}  // namespace brindle::paraview
