/// Singularities of a line field, and strokes that move them.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "brindle/corner_phases.h"
#include "brindle/strokes.h"
#include "brindle/surface.h"

namespace brindle::tool {

/// A triangle round which the field's lines turn by half a turn.
struct FieldSingularity {
  std::size_t triangle = 0;
  Vec3 position;  ///< its barycentre, relative to the mesh's origin
  Vec3 normal;    ///< not of unit length, to the side of the vertices' normals
  int sign = 0;   ///< 1: lines turn with who walks round it, -1: against
};

/// Those among `corners`, one entry per triangle, of the field with these directions, one per
/// vertex.
std::vector<FieldSingularity> field_singularities(const Surface& surface,
                                                  std::span<const CornerPhases> corners,
                                                  std::span<const Vec3> directions);

/// Strokes with which a smooth field, now `directions`, has the singularity in the triangle `to`
/// instead of its own. If one of the other sign is there, both are gone. They lie up to `reach`, in
/// units of length and at least three edges, from a path between both triangles, and run along the
/// smoothest field that is the old one farther away and has its singularities there: with turns
/// from vertex to vertex, of which those across the path are one half turn more or less, a
/// least-squares problem (compare Crane et al., Trivial connections on discrete surfaces, 2010).
/// Empty if no path joins the triangles nearby.
std::vector<FieldStroke> strokes_that_move(const FieldSingularity& singularity, std::size_t to,
                                           const Surface& surface, std::span<const Vec3> directions,
                                           double reach, double strength);

}  // namespace brindle::tool
