/// Singularities of a line field, and strokes that move them.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "brindle/corner_phases.h"
#include "brindle/strokes.h"
#include "brindle/surface.h"

namespace brindle::tool {

/// A triangle around which the field's lines make half a turn.
struct FieldSingularity {
  std::size_t triangle = 0;
  Vec3 position;  ///< its barycentre, relative to the mesh's origin
  Vec3 normal;    ///< not normalized, on the side of the vertex normals
  int sign = 0;   ///< 1: lines turn in the sense of the walk around it, -1: against it
};

/// Those among `corners`, one entry per triangle, of the field with these directions, one per
/// vertex.
std::vector<FieldSingularity> field_singularities(const Surface& surface,
                                                  std::span<const CornerPhases> corners,
                                                  std::span<const Vec3> directions);

/// Strokes that move the singularity of a smooth field, now `directions`, to the triangle `to`. A
/// singularity of the opposite sign there cancels with it. The strokes are within `reach` (a
/// length, at least three edges) of a path between both triangles. They follow the smoothest field
/// that equals the old one farther away and has the moved singularity: a least-squares problem for
/// rotations at vertices, with an extra half turn across the path (compare Crane et al., Trivial
/// connections on discrete surfaces, 2010). Empty if no nearby path joins the triangles.
std::vector<FieldStroke> strokes_that_move(const FieldSingularity& singularity, std::size_t to,
                                           const Surface& surface, std::span<const Vec3> directions,
                                           double reach, double strength);

/// Adds strokes that fix singularities, replacing held ones nearby: old strokes must not pull
/// against new ones.
std::vector<FieldStroke> with_steering(std::vector<FieldStroke> held,
                                       const std::vector<FieldStroke>& added);

/// A dragged and released singularity.
struct DroppedSingularity {
  std::size_t to = 0;      ///< its target triangle
  int sign = 0;            ///< its own
  bool meets = false;      ///< a singularity of the opposite sign was there
  std::size_t before = 0;  ///< number of singularities of the field
};

/// The outcome of a drag.
struct Arrival {
  bool there = false;
  const FieldSingularity* nearest = nullptr;  ///< of the same sign; null: none is left
  double distance = 0;                        ///< from that to the target
  int others = 0;                             ///< change of the number of other singularities
};

/// For a field with these singularities now. It has arrived if it is within `reach` or two edges of
/// the target; if it met another one, if neither is there.
Arrival arrival_of(const DroppedSingularity& dropped, const Surface& surface,
                   std::span<const FieldSingularity> after, double reach);

/// The same as text with a remedy. Distances are relative to this diagonal.
std::string arrival_words(const DroppedSingularity& dropped, const Arrival& arrival,
                          double diagonal);

}  // namespace brindle::tool
