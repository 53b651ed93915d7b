/// Waves so fine that nothing can be told of them.
#pragma once

#include <cstddef>
#include <limits>
#include <span>
#include <string>

#include "brindle/phase_graph.h"
#include "brindle/types.h"

namespace brindle {

/// How many edges a wave must pass within a period at half of the vertices, and at each: phases,
/// which are floats, would be rounding errors otherwise.
inline constexpr double kFewestEdgesAtHalf = 1e-4;
inline constexpr double kFewestEdgesAnywhere = 1e-6;

/// How far the edges of a vertex run along its wave, on average.
double mean_length_along(std::span<const Vec3> positions, Index vertex,
                         std::span<const Index> neighbors, const Vec3& direction);

/// Vertices whose waves pass few edges a period.
struct FinenessTally {
  std::size_t measured = 0;  ///< vertices with a wave and an edge along it
  std::size_t too_fine = 0;  ///< of these, those that pass kFewestEdgesAtHalf or fewer
  double fewest = std::numeric_limits<double>::infinity();  ///< edges a period
  Index vertex = 0;                                         ///< where
  float frequency = 0;                                      ///< there

  FinenessTally operator+(const FinenessTally& other) const;
};

/// Whether any wave can be too fine; costs next to nothing, and is false of nearly all.
bool may_be_too_fine(std::span<const Vec3> positions, std::span<const float> frequencies);

/// Spans have one entry per vertex, with values that `check_waves` takes.
FinenessTally tally_fineness(const Adjacency& neighborhood, std::span<const Vec3> positions,
                             std::span<const Vec3> directions, std::span<const float> frequencies);

/// Throws Error if half of the vertices or one of them have waves that are too fine. The message
/// names the finest one's vertex and frequency and says `fewer`, the remedy.
void check_fineness(const FinenessTally& tally);
void check_fineness(const Adjacency& neighborhood, std::span<const Vec3> positions,
                    std::span<const Vec3> directions, std::span<const float> frequencies);

[[noreturn]] void refuse_noise(double edges_per_period, const std::string& where,
                               const std::string& fewer);

}  // namespace brindle
