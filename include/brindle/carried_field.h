/// Direction fields of one surface as the next one finds them, on the same mesh or on another: what
/// smooth fields of a time series go on from (docs/method.md, "Fields of surfaces that move").
#pragma once

#include <cstddef>
#include <limits>
#include <span>
#include <vector>

#include "brindle/carried_phases.h"
#include "brindle/direction_field.h"
#include "brindle/export.h"
#include "brindle/mesh.h"
#include "brindle/surface.h"
#include "brindle/types.h"

namespace BRINDLE_EXPORT brindle {

/// A field that others go on from.
struct LastField {
  const Mesh& mesh;
  std::span<const Vec3> normals;     ///< one unit normal per vertex, or zero
  std::span<const Vec3> directions;  ///< one unit tangent vector per vertex, or zero for none
};

/// For every vertex of `surface` the direction of the last field's vertex with the same number or,
/// if `counterparts` are given, with the number that stands there (`kNoCounterpart`: with none).
/// Directions go along with the surface: each turns as its vertex's neighbours have turned about
/// it, by the angle that fits best, so that what moves as a whole takes its field with it exactly.
/// Zero where there is nothing to go on from. Throws Error if sizes do not match or a counterpart
/// does not exist.
DirectionField matched_directions(const LastField& last, const Surface& surface,
                                  std::span<const Index> counterparts = {});

/// For every vertex of `surface` the direction that the last field has at the nearest place of its
/// triangles, or at its nearest vertex if it has none, projected into the tangent plane. Between
/// the corners of a triangle directions are blended as those of a field of this symmetry (1 vector,
/// 2 line, 4 cross). Zero where the last surface is farther away than `max_distance`, has no
/// direction, or one along the normal. Throws Error if sizes do not match, for a symmetry below 1,
/// and for a distance that is not above 0.
DirectionField carried_directions(const LastField& last, const Surface& surface, int symmetry = 2,
                                  double max_distance = std::numeric_limits<double>::infinity());

/// One over the mean frequency of waves: as far as a field is known around its surface. Infinite if
/// there are none.
double mean_period(const WaveSet& waves);

/// How far directions turned since the last field.
struct FieldStep {
  double mean_deg = 0;  ///< of the angles between both, in degrees, where both are known; of a
                        ///< field of symmetry N none is larger than 180 / N
  std::size_t unmatched = 0;  ///< directions without a last one
};

/// `last` as one of the functions above gives it. Throws Error if sizes do not match, and for a
/// symmetry below 1.
FieldStep field_step(std::span<const Vec3> directions, std::span<const Vec3> last,
                     int symmetry = 2);

}  // namespace brindle
