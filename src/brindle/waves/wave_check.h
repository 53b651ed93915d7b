/// Rejects invalid waves, phases, weights and spacing tolerances.
#pragma once

#include <cstddef>
#include <limits>
#include <span>
#include <string>

#include "brindle/base/archive.h"
#include "brindle/phase_graph.h"
#include "brindle/spacing_tolerance.h"
#include "brindle/types.h"

namespace brindle {

/// Throws Error unless waves are valid (`WaveSet`). The message names the first vertex that is
/// invalid, the reason and the remedy. All spans have one entry per vertex.
void check_waves(std::span<const Vec3> positions, std::span<const Vec3> directions,
                 std::span<const float> frequencies);

/// Angles between directions and their tangent planes, of vertices with a direction and a normal.
struct TangentStats {
  std::size_t counted = 0;
  std::size_t slanted = 0;  ///< by more than 10 degrees
  float largest_sine = 0;   ///< of these angles
  std::size_t vertex = 0;   ///< the first with that angle
};

TangentStats tally_tangent(std::span<const Vec3> normals, std::span<const Vec3> directions);

/// Throws Error unless directions are tangent: none is more than 60 degrees out of the tangent
/// plane, and at most a tenth are more than 10 degrees out. Directions projected along normals of
/// another weighting pass; directions along normals, or in one plane, do not. A wave that is 10
/// degrees out is spaced 1.5 % too wide. The message names the vertex, the angle and the remedy.
void check_tangent(const TangentStats& tally);
void check_tangent(std::span<const Vec3> normals, std::span<const Vec3> directions);

/// Throws Error if a direction is more than 4 degrees out of its tangent plane.
void check_turnable(std::span<const Vec3> normals, std::span<const Vec3> directions);

/// Throws Error unless there is one phase for each of `count` vertices, of length 1 (to half a
/// percent) or 0. The message names the first that is not.
void check_last_phases(std::span<const Complex> z, std::size_t count);

/// Throws Error unless all edge weights are finite and not negative, naming the first that is not.
void check_edge_weights(std::span<const float> weights);

/// Throws Error unless `waves` has one entry per node and `edge_weights` one per directed edge, or
/// none, and for values that `check_waves` and `check_edge_weights` reject.
void check_coupled_waves(const Adjacency& adjacency, const WaveSet& waves,
                         std::span<const float> edge_weights);

/// The largest anchor weight: beyond it, couplings vanish in rounding and sums of squares overflow.
inline constexpr float kLargestWeight = 1e6f;

/// False for NaN.
inline bool is_weight(float weight) { return weight >= 0 && weight <= kLargestWeight; }

/// Throws Error for a slack that is negative or not finite and for `branch_penalty` outside 0 to 1,
/// naming the vertex; and for a nonempty list without one entry per vertex.
void check_slack(const Slack& slack, std::size_t vertices);

// Rejects waves that are too fine to be solved for.

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

/// Waves of this many nodes in an archive. Throws Error as `check_waves` does.
void archive_waves(Archive& archive, std::size_t nodes, WaveSet& waves);

void archive_change(Archive& archive, FrequencyChange& change);

}  // namespace brindle
