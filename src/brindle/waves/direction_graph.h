/// Smooth direction fields as a phase graph (docs/method.md; Knöppel et al. 2013).
#pragma once

#include <cstddef>
#include <memory>
#include <span>

#include "brindle/direction_field.h"
#include "brindle/phase_graph.h"
#include "brindle/progress.h"
#include "brindle/surface.h"

namespace brindle {

/// The fixed tangent basis (x, y) of a unit normal: x × y = normal.
struct TangentBasis {
  Vec3 x;
  Vec3 y;
};
TangentBasis tangent_basis(const Vec3& normal);

/// Normals with a smaller product, more than 114 degrees apart, point to opposite sides, as on
/// unorientable surfaces. All others belong to a bend.
inline constexpr float kOppositeSides = -0.4f;

/// The number of directed edges between such normals, of the nodes that have neighbours.
std::size_t count_opposite_edges(const Adjacency& adjacency, std::span<const Vec3> normals);

/// `vector` turned by the smallest rotation from the unit normal `from` to `to`: tangent vectors
/// stay tangent. NaN if they are opposite.
Vec3 transported(const Vec3& vector, const Vec3& from, const Vec3& to);

/// An N-direction field as a phase graph (Knöppel et al. 2013). Node i has u_i = exp(i N theta_i),
/// with the angle theta_i of one of its N directions in the tangent basis. A_ij = exp(i N rho_ji),
/// with the angle rho_ji of parallel transport from j to i. Edges whose normals point to opposite
/// sides (unorientable surfaces) count angles in opposite senses and are reflecting, B_ij. All
/// weights are 1. `normals` has one entry per node, `symmetry` is N. Throws Error if sizes do not
/// match, and for a normal that is not finite, naming the first.
PhaseGraph build_direction_graph(std::shared_ptr<const Adjacency> adjacency,
                                 std::span<const Vec3> normals, int symmetry,
                                 const Progress& progress = {});

/// The same with one weight per directed edge. Avoids angles, which takes a third of the time;
/// results are equal up to rounding.
PhaseGraph build_weighted_direction_graph(std::shared_ptr<const Adjacency> adjacency,
                                          std::span<const Vec3> normals, int symmetry,
                                          std::span<const float> weights,
                                          const Progress& progress = {});

/// The graph of a surface's vertices. Vertices on the two sides of a crease are linked weakly, so
/// that faces agree on one of several equally smooth fields. With full weights, rims of holes would
/// turn the field of flat faces.
PhaseGraph direction_graph_of(const Surface& surface, int symmetry, const Progress& progress = {});

/// u = exp(i N theta) of a tangent direction; zero for a zero direction.
Complex representation(const Vec3& direction, const Vec3& normal, int symmetry);

/// exp(i arg(u) / N), for N = 1, 2 and 4 without angles; 1 if u is 0.
Complex unit_root(const Complex& u, int symmetry);

/// One of the N directions of each u: theta = arg(u) / N; zero where the normal is zero.
DirectionField directions_of(std::span<const Complex> u, std::span<const Vec3> normals,
                             int symmetry, const Progress& progress = {});

}  // namespace brindle
