/// Continues a smooth field from known directions, such as those of the last frame.
#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <vector>

#include "brindle/direction_field.h"
#include "brindle/phase_graph.h"
#include "brindle/smooth_field.h"
#include "brindle/types.h"

namespace brindle {

/// The last field at the nodes of a direction graph.
struct LastValues {
  std::vector<Complex> u;         ///< exp(i N theta); 0 if unknown
  std::vector<float> confidence;  ///< 0 or above
  float weight = 0;               ///< of the pull, relative to that of all neighbours
  std::vector<float> noisy = {};  ///< by node: strength of new anchors, such as curvature; empty: 0
};

/// Anchor strength by node.
std::vector<float> anchor_strengths(const PhaseGraph& graph);

/// Returns the start values of the new field. Adds the pull towards them to `graph.anchor`, which
/// holds all other anchors. The last field is smoothed with those anchors over a large part of the
/// surface. Zeros of a smoothed field move with the shape; those of a unit field stay trapped
/// between vertices. `fill` solves from scratch, and is only called if values are missing.
std::vector<Complex> warm_start(PhaseGraph& graph, const LastValues& last,
                                const std::function<std::vector<Complex>()>& fill);

/// Throws Error for a weight out of range, for numbers that are not finite, and for a number of
/// directions other than 0 or one per vertex. `what` starts the message.
void check_known(const KnownDirections& known, std::size_t vertices, const char* what);

/// Known directions as values of a field of symmetry N on these normals.
LastValues last_values(const KnownDirections& known, std::span<const Vec3> normals, int symmetry);

/// The direction nearest to the tangent vector `last`, among the N that `u` represents.
Vec3 direction_near(const Vec3& last, Complex u, const Vec3& normal, int symmetry);

/// Matches axes and signs with the last field where it has a direction, elsewhere with the
/// neighbours. `u` are the values of `field`.
void align_with_previous(const Adjacency& neighborhood, std::span<const Complex> u,
                         std::span<const Vec3> normals, std::span<const Vec3> last, int symmetry,
                         DirectionField& field);

}  // namespace brindle
