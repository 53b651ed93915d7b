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

/// Strokes that hold singularities, with new ones, which take the place of those nearby: what held
/// one where it was does not pull against what moves it on.
std::vector<FieldStroke> with_steering(std::vector<FieldStroke> held,
                                       const std::vector<FieldStroke>& added);

/// A singularity that was dragged and let go.
struct DroppedSingularity {
  std::size_t to = 0;      ///< the triangle where it is to be
  int sign = 0;            ///< its own
  bool meets = false;      ///< one of the other sign was there
  std::size_t before = 0;  ///< how many the field had
};

/// What became of it.
struct Arrival {
  bool there = false;
  const FieldSingularity* nearest = nullptr;  ///< of its sign; null: there is none any more
  double distance = 0;                        ///< of that from where it is to be
  int others = 0;  ///< how many more there are now than there should be, or fewer
};

/// In a field that has these singularities now. It is there if it is no farther than `reach` or two
/// edges from its triangle; if it met another one, if neither is there.
Arrival arrival_of(const DroppedSingularity& dropped, const Surface& surface,
                   std::span<const FieldSingularity> after, double reach);

/// The same in words, with the remedy. Distances are shares of this diagonal.
std::string arrival_words(const DroppedSingularity& dropped, const Arrival& arrival,
                          double diagonal);

}  // namespace brindle::tool
