/// Direction fields: one tangent vector per vertex, along which its wave runs.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "brindle/export.h"
#include "brindle/mesh.h"
#include "brindle/normals.h"
#include "brindle/progress.h"
#include "brindle/surface.h"
#include "brindle/types.h"

namespace BRINDLE_EXPORT brindle {

/// One direction per vertex: a unit tangent vector up to sign (d ~ -d), or zero for no wave.
using DirectionField = std::vector<Vec3>;

/// `vector` projected into the tangent plane and normalised; zero if it is zero, not finite or
/// nearly parallel to the unit normal, or if the normal is zero.
Vec3 tangent_direction(const Vec3& vector, const Vec3& normal);

/// `tangent_direction` of every vertex. `vectors` and `normals` have one entry per vertex.
DirectionField tangent_directions(std::span<const Vec3> vectors, std::span<const Vec3> normals);

/// The global vector `axis` projected into every tangent plane. Throws Error if `axis` is zero or
/// not finite.
DirectionField projected_direction_field(const Vec3& axis, std::span<const Vec3> normals);

/// The principal direction of larger (maximum) or smaller (minimum) absolute curvature.
enum class CurvatureDirection { maximum, minimum };

/// One principal direction per vertex.
DirectionField curvature_direction_field(std::span<const PrincipalCurvature> curvatures,
                                         CurvatureDirection direction);

/// Every direction turned by `radians` about its vertex's normal, counter-clockwise seen from the
/// tip of the normal. Spans have one entry per vertex.
DirectionField rotated(std::span<const Vec3> directions, std::span<const Vec3> normals,
                       float radians);

// Singularities of direction fields.

/// The index of an N-direction field (N = `symmetry`) on a triangle, in N-th parts of a whole turn,
/// counter-clockwise seen from the tip of `normal`; 0 without a singularity (Ray et al. 2008).
/// `normal` may have any length; `directions` are those of the corners.
int field_index(const Vec3& normal, const std::array<Vec3, 3>& directions, int symmetry);

/// A triangle with a singularity.
struct SingularTriangle {
  Index triangle;
  int index;  ///< `field_index`, not 0
};

/// The singular triangles of an N-direction field, in ascending order. Triangles with a corner
/// without a direction do not count. `directions` has one entry per vertex.
std::vector<SingularTriangle> singular_triangles(const Mesh& mesh, std::span<const Vec3> directions,
                                                 int symmetry);

/// The number of singular triangles.
std::size_t count_singularities(const Mesh& mesh, std::span<const Vec3> directions, int symmetry);

// Consistent signs of directions that are defined up to sign.

/// Reverses directions, breadth-first from the first vertex of every component, so that each runs
/// like the neighbours visited before. Patterns do not depend on signs, but solvers are faster with
/// few reflecting edges. Where no consistent choice exists, some edges stay reflecting.
/// `directions` has one entry per vertex. Throws Cancelled if `progress` cancels; some directions
/// are reversed then.
void orient_alike(const Adjacency& neighborhood, std::span<Vec3> directions,
                  const Progress& progress = {});

/// As above over a whole surface: on the two sides of a crease, directions run alike once it is
/// unfolded.
void orient_alike(const Surface& surface, std::span<Vec3> directions,
                  const Progress& progress = {});

/// As above, starting from settled directions (1), which do not change.
void orient_alike(const Adjacency& neighborhood, std::span<const std::uint8_t> settled,
                  std::span<Vec3> directions);

/// Reverses directions that run against `reference`, which has one entry per direction.
void orient_like(std::span<const Vec3> reference, std::span<Vec3> directions);

}  // namespace brindle
