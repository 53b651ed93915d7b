/// Fields of a surface that is seen with averaged normals, handed on from one average to another.
#pragma once

#include <span>
#include <vector>

#include "brindle/direction_field.h"
#include "brindle/types.h"

namespace brindle {

/// The distances over which the normals are averaged that a field of averaged normals goes through,
/// from the last to the first; one that goes on from the field before begins with that.
std::vector<float> averaging_radii(float normal_radius, bool goes_on);

/// A field that is tangent to some normals of a surface.
struct SeenField {
  std::vector<Vec3> normals;
  DirectionField directions;
};

/// Directions that are tangent to some normals, turned until they are to others.
void turn_to_normals(std::span<const Vec3> from, std::span<const Vec3> to, DirectionField& field);

/// A field's values in the direction graph of other normals, 0 where it has none.
std::vector<Complex> values_at(SeenField field, std::span<const Vec3> normals, int symmetry);

}  // namespace brindle
