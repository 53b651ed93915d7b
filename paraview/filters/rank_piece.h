/// One rank's piece of a surface that all ranks hold together.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
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

/// Collective where it is made, and where it says so.
class RankPiece {
 public:
  RankPiece(const Ranks& ranks, const Mesh& mesh, std::vector<std::uint64_t> numbers,
            std::vector<std::uint8_t> ghost_triangles);

  const Ranks& ranks() const { return ranks_; }
  const DistributedSurface& surface() const { return surface_; }
  const OwnerExchange& owners() const { return owners_; }
  /// One per triangle: 1 if it is another rank's.
  std::span<const std::uint8_t> ghosts() const { return ghosts_; }

  /// A pattern of this piece's vertices, as the library asks for it; valid as long as both are.
  PiecePattern part_of(const StripePattern& pattern) const {
    return {surface_, pattern.waves, pattern.solution.z, pattern.phase_shift};
  }

  /// Whether vertices have the same owners, and triangles are ghosts, as in the other one.
  bool is_shared_like(const RankPiece& other) const;

  /// Collective. What `cells_to_points` gives of rows per triangle, ghosts' rows left out and other
  /// ranks' counted.
  DataArray cells_to_points(const Mesh& mesh, const DataArray& rows) const;

  /// Collective. The smallest and the largest number of all ranks, where each has some; the first
  /// above the second if none has.
  std::array<double, 2> extent(std::array<double, 2> own) const;

 private:
  /// At a vertex the row of a triangle counts times this.
  using Sign = std::function<double(std::size_t triangle, Index vertex)>;

  /// Collective. Means of rows of numbers at vertices.
  std::vector<double> means_of(const Mesh& mesh, std::span<const double> rows, std::size_t columns,
                               const Sign& sign) const;

  /// A vertex as its owner knows it.
  struct Source {
    int rank;
    Index vertex;
    bool operator==(const Source&) const = default;
  };

  Ranks ranks_;
  std::vector<std::uint8_t> ghosts_;
  DistributedSurface surface_;
  OwnerExchange owners_;
  std::vector<Source> sources_;  ///< per vertex
};

}  // namespace brindle::paraview
