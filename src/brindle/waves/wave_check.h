/// Rejects invalid waves, phases and weights.
#pragma once

#include <cstddef>
#include <span>

#include "brindle/phase_graph.h"
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

}  // namespace brindle
