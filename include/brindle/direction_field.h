/// Direction fields: one tangent vector per vertex, along which its wave runs.
#pragma once

#include <span>
#include <vector>

#include "brindle/export.h"
#include "brindle/normals.h"
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

}  // namespace brindle
