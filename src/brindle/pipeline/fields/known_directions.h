/// What directions that are known of a smooth field add to it.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "brindle/direction_field.h"
#include "brindle/pipeline/fields/followed_field.h"
#include "brindle/smooth_field.h"
#include "brindle/types.h"

namespace brindle {

/// Throws Error for a weight out of range, for other than one direction per vertex, or none at all,
/// and for numbers that are not finite. `what` begins its messages.
void check_known(const KnownDirections& known, std::size_t vertices, const char* what);

/// As values of a field of symmetry N on vertices with these normals.
LastValues last_values(const KnownDirections& known, std::span<const Vec3> normals, int symmetry);

/// The direction that `u` stands for which is nearest to `last`, a tangent vector.
Vec3 direction_near(const Vec3& last, Complex u, const Vec3& normal, int symmetry);

/// Names and signs directions as the last field does where it has one, and the others as their
/// neighbours run. `u` are the values of `field`.
void name_like_last(const Adjacency& neighborhood, std::span<const Complex> u,
                    std::span<const Vec3> normals, std::span<const Vec3> last, int symmetry,
                    DirectionField& field);

}  // namespace brindle
