/// Averaged normals of a surface, and transfer of fields between sets of normals.
#pragma once

#include <span>
#include <vector>

#include "brindle/direction_field.h"
#include "brindle/progress.h"
#include "brindle/surface.h"
#include "brindle/types.h"

namespace brindle {

/// Unit normals averaged over the surface, one set for each of `radii`. Radii are root mean square
/// distances in units of length, above 0 and ascending. Zero where the surface's normals are; the
/// surface's own where the average vanishes. Independent of the mesh resolution. Throws Cancelled
/// if `progress` asks for it.
std::vector<std::vector<Vec3>> averaged_normals(const Surface& surface,
                                                std::span<const float> radii,
                                                const Progress& progress = {});

/// Averaging radii of a coarse-to-fine solve, ascending; it starts with the last. A field that
/// continues (`goes_on`) from a previous one only needs the first.
std::vector<float> averaging_radii(float normal_radius, bool goes_on);

/// A field that is tangent to some normals of a surface.
struct FieldOnNormals {
  std::vector<Vec3> normals;
  DirectionField directions;
};

/// Rotates directions tangent to `from` until they are tangent to `to`.
void turn_to_normals(std::span<const Vec3> from, std::span<const Vec3> to, DirectionField& field);

/// The field's values in the direction graph of `normals`; 0 without a direction.
std::vector<Complex> values_at(FieldOnNormals field, std::span<const Vec3> normals, int symmetry);

}  // namespace brindle
