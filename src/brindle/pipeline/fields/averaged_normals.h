/// Normals of a surface as it is seen from farther away, and fields handed on between them.
#pragma once

#include <span>
#include <vector>

#include "brindle/direction_field.h"
#include "brindle/progress.h"
#include "brindle/surface.h"
#include "brindle/types.h"

namespace brindle {

/// For each of `radii`, which ascend, in units of length and above 0, the surface's normals
/// averaged over places whose root mean square distance it is; of unit length. Zero where the
/// surface's are, and the surface's own where their average has no direction. A finer mesh has the
/// same. Throws Cancelled if `progress` asks for it.
std::vector<std::vector<Vec3>> averaged_normals(const Surface& surface,
                                                std::span<const float> radii,
                                                const Progress& progress = {});

/// The distances over which the normals are averaged that a field of averaged normals goes through,
/// from the last to the first; one that goes on from the field before begins with that.
std::vector<float> averaging_radii(float normal_radius, bool goes_on);

/// A field that is tangent to some normals of a surface.
struct FieldOnNormals {
  std::vector<Vec3> normals;
  DirectionField directions;
};

/// Directions that are tangent to some normals, turned until they are to others.
void turn_to_normals(std::span<const Vec3> from, std::span<const Vec3> to, DirectionField& field);

/// A field's values in the direction graph of other normals, 0 where it has none.
std::vector<Complex> values_at(FieldOnNormals field, std::span<const Vec3> normals, int symmetry);

}  // namespace brindle
