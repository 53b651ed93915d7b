/// Direction fields carried over from the last surface of a time series, as a start for smooth
/// fields (docs/method.md, "Fields of surfaces that move").
#pragma once

#include <cstddef>
#include <limits>
#include <span>

#include "brindle/carried_phases.h"
#include "brindle/direction_field.h"
#include "brindle/export.h"
#include "brindle/mesh.h"
#include "brindle/surface.h"
#include "brindle/types.h"

namespace BRINDLE_EXPORT brindle {

/// The last field of a series.
struct LastField {
  const Mesh& mesh;
  std::span<const Vec3> normals;     ///< one unit normal per vertex, or zero
  std::span<const Vec3> directions;  ///< one unit tangent vector per vertex, or zero for none
};

/// For every vertex of `surface`, the direction at its counterpart in the last field: the vertex
/// with the same number or, if given, with the number in `counterparts` (`kNoCounterpart`: none).
/// Each direction turns with the surface, by the angle that best fits its neighbours' turn about
/// the vertex. A rigid motion thus carries the field exactly. Zero where no last direction is
/// known. Throws Error if sizes do not match or a counterpart does not exist.
DirectionField matched_directions(const LastField& last, const Surface& surface,
                                  std::span<const Index> counterparts = {});

/// For every vertex of `surface`, the direction of the last field at the nearest point of its
/// triangles, or at its nearest vertex if it has none, projected into the tangent plane. Inside a
/// triangle, directions are blended as a field of this symmetry (1 vector, 2 line, 4 cross). Zero
/// where the last surface is farther than `max_distance`, has no direction, or one along the
/// normal. Throws Error if sizes do not match, for a symmetry below 1, and for a distance that is
/// not above 0.
DirectionField carried_directions(const LastField& last, const Surface& surface, int symmetry = 2,
                                  double max_distance = std::numeric_limits<double>::infinity());

/// 1 over the mean frequency of waves, a `max_distance` for `carried_directions`. Infinite without
/// waves.
double mean_period(const WaveSet& waves);

/// The change of directions since the last field.
struct FieldStep {
  /// Mean angle in degrees, where both are known; at most 180 / N in a field of symmetry N.
  double mean_deg = 0;
  std::size_t unmatched = 0;  ///< directions without a last direction
};

/// `last` is a result of one of the functions above. Throws Error if sizes do not match, and for a
/// symmetry below 1.
FieldStep field_step(std::span<const Vec3> directions, std::span<const Vec3> last,
                     int symmetry = 2);

}  // namespace brindle
