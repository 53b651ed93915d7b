/// Direction fields: one tangent vector per vertex that says where a vertex's wave runs.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "brindle/export.h"
#include "brindle/normals.h"
#include "brindle/types.h"

namespace BRINDLE_EXPORT brindle {

/// One direction per vertex: a unit tangent vector, meant up to sign (d ~ -d), or zero for
/// "no wave here".
using DirectionField = std::vector<Vec3>;

/// `vector` projected into the tangent plane and made a unit vector; zero if it is zero, not finite
/// or (nearly) parallel to the unit normal, or if there is no normal (zero).
Vec3 tangent_direction(const Vec3& vector, const Vec3& normal);

/// Projects every vector into the tangent plane of its vertex and makes it a unit vector. Vectors
/// that are zero, not finite or (nearly) parallel to the normal become zero.
/// `vectors` and `normals` have one entry per vertex.
DirectionField tangent_directions(std::span<const Vec3> vectors, std::span<const Vec3> normals);

/// The global vector `axis` (any length but zero) projected into every tangent plane.
/// Throws Error if `axis` is zero or not finite.
DirectionField projected_direction_field(const Vec3& axis, std::span<const Vec3> normals);

enum class CurvatureDirection { maximum, minimum };

/// The principal direction of larger (maximum) or smaller absolute curvature.
DirectionField curvature_direction_field(std::span<const PrincipalCurvature> curvatures,
                                         CurvatureDirection direction);

/// Turns every direction by `radians` about its vertex's normal, counter-clockwise seen from its
/// tip.
DirectionField rotated(std::span<const Vec3> directions, std::span<const Vec3> normals,
                       float radians);

}  // namespace brindle
