/// Smooth direction fields as a phase graph (docs/method.md; Knöppel et al. 2013).
#pragma once

#include <memory>
#include <span>

#include "brindle/direction_field.h"
#include "brindle/phase_graph.h"
#include "brindle/progress.h"

namespace brindle {

/// The fixed tangent basis (x, y) of a unit normal: x × y = normal.
struct TangentBasis {
  Vec3 x;
  Vec3 y;
};
TangentBasis tangent_basis(const Vec3& normal);

/// Normals whose product is less, of more than 114 degrees, point to opposite sides, as somewhere
/// on an unorientable surface; all others are those of a bend.
inline constexpr float kOppositeSides = -0.4f;

/// `vector` turned by the smallest rotation that takes the unit normal `from` to `to`; what is
/// tangent at one is tangent at the other. Not a number where they are opposite.
Vec3 transported(const Vec3& vector, const Vec3& from, const Vec3& to);

/// An N-direction field as a phase graph: node i has u_i = exp(i N theta_i), theta_i the angle of
/// one of its N directions in the tangent basis, and A_ij = exp(i N rho_ji) with the angle rho_ji
/// of parallel transport from j to i. Where the normals of an edge point to opposite sides
/// (unorientable surfaces), angles are counted against each other: there the edge is reflecting,
/// B_ij. All weights are 1. `normals` has one entry per node, `symmetry` is N. Throws Error if
/// sizes do not match, and for a normal that is not finite, naming the first.
PhaseGraph build_direction_graph(std::shared_ptr<const Adjacency> adjacency,
                                 std::span<const Vec3> normals, int symmetry,
                                 const Progress& progress = {});

/// The same with a weight for every edge, for who needs it soon: without angles, in a third of the
/// time, and so the same but for rounding.
PhaseGraph build_weighted_direction_graph(std::shared_ptr<const Adjacency> adjacency,
                                          std::span<const Vec3> normals, int symmetry,
                                          std::span<const float> weights,
                                          const Progress& progress = {});

/// u = exp(i N theta) of a tangent direction; zero for a zero direction.
Complex representation(const Vec3& direction, const Vec3& normal, int symmetry);

/// exp(i arg(u) / N), of 1, 2 and 4 without any angle; 1 if u is 0.
Complex unit_root(const Complex& u, int symmetry);

/// One of the N directions that each u stands for: theta = arg(u) / N. Zero where the normal is.
DirectionField directions_of(std::span<const Complex> u, std::span<const Vec3> normals,
                             int symmetry, const Progress& progress = {});

}  // namespace brindle
