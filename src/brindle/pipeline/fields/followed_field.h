/// How a smooth field goes on from directions that are known, such as those of the field before.
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
  std::vector<Complex> u;         ///< exp(i N theta), 0 where nothing is known
  std::vector<float> confidence;  ///< 0 or above
  float weight = 0;               ///< of the pull, in multiples of what all neighbours pull
  std::vector<float> noisy = {};  ///< how strongly a node is attracted by what is measured anew,
                                  ///< as curvature is; empty: not
};

/// How strongly the anchors that a graph has attract its nodes.
std::vector<float> anchor_strengths(const PhaseGraph& graph);

/// Where the new field starts; `graph.anchor`, which has what else attracts it, also gets the pull
/// towards there. The last field is smoothed together with those anchors, over a length that is a
/// good part of the surface: the zeros of a smoothed field move on with the shape, where those of a
/// field of unit length stay caught between vertices. `fill` solves for the graph's field from
/// scratch; it is asked if somewhere nothing is known.
std::vector<Complex> warm_start(PhaseGraph& graph, const LastValues& last,
                                const std::function<std::vector<Complex>()>& fill);

/// Throws Error for a weight out of range, for other than one direction per vertex, or none at all,
/// and for numbers that are not finite. `what` begins its messages.
void check_known(const KnownDirections& known, std::size_t vertices, const char* what);

/// As values of a field of symmetry N on vertices with these normals.
LastValues last_values(const KnownDirections& known, std::span<const Vec3> normals, int symmetry);

/// The direction that `u` stands for which is nearest to `last`, a tangent vector.
Vec3 direction_near(const Vec3& last, Complex u, const Vec3& normal, int symmetry);

/// Names and signs directions as the last field does where it has one, and the others as their
/// neighbours run. `u` are the values of `field`.
void align_with_previous(const Adjacency& neighborhood, std::span<const Complex> u,
                         std::span<const Vec3> normals, std::span<const Vec3> last, int symmetry,
                         DirectionField& field);

}  // namespace brindle
