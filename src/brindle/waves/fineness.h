/// Rejects waves that are too fine to be solved for.
#pragma once

#include <cstddef>
#include <limits>
#include <span>
#include <string>

#include "brindle/phase_graph.h"
#include "brindle/types.h"

namespace brindle {

/// The fewest edges per period at half of the vertices, and at each. With fewer edges, float phases
/// would be rounding errors.
inline constexpr double kFewestEdgesAtHalf = 1e-4;
inline constexpr double kFewestEdgesAnywhere = 1e-6;

/// The mean length of a vertex's edges along its wave.
double mean_length_along(std::span<const Vec3> positions, Index vertex,
                         std::span<const Index> neighbors, const Vec3& direction);

/// Vertices with few edges per period.
struct FinenessTally {
  std::size_t measured = 0;  ///< vertices with a wave and an edge along it
  std::size_t too_fine = 0;  ///< of these, vertices with kFewestEdgesAtHalf or fewer
  double fewest = std::numeric_limits<double>::infinity();  ///< the fewest edges per period
  Index vertex = 0;                                         ///< the vertex with the fewest
  float frequency = 0;                                      ///< at that vertex

  FinenessTally operator+(const FinenessTally& other) const;
};

/// Whether any wave can be too fine: a fast, conservative test that is rarely true.
bool may_be_too_fine(std::span<const Vec3> positions, std::span<const float> frequencies);

/// Spans have one entry per vertex, with values that `check_waves` accepts.
FinenessTally tally_fineness(const Adjacency& neighborhood, std::span<const Vec3> positions,
                             std::span<const Vec3> directions, std::span<const float> frequencies);

/// Throws Error if the waves of half of the vertices, or of one, are too fine. The message names
/// the vertex and frequency of the finest, and the remedy.
void check_fineness(const FinenessTally& tally);
void check_fineness(const Adjacency& neighborhood, std::span<const Vec3> positions,
                    std::span<const Vec3> directions, std::span<const float> frequencies);

/// Throws the Error of `check_fineness`; `where` is the place, `fewer` the remedy.
[[noreturn]] void refuse_noise(double edges_per_period, const std::string& where,
                               const std::string& fewer);

}  // namespace brindle
