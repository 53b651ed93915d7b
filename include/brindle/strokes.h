/// Strokes: lines near a surface that its smooth direction field follows.
#pragma once

#include <span>
#include <vector>

#include "brindle/export.h"
#include "brindle/progress.h"
#include "brindle/surface.h"
#include "brindle/types.h"

namespace BRINDLE_EXPORT brindle {

/// A line near a surface that attracts the field. It is given in space, not by vertices, so it
/// remains valid when the mesh is refined, moved by its origin or replaced. Strokes are undirected.
struct FieldStroke {
  std::vector<Eigen::Vector3d> points;  ///< two or more, in the coordinates of the mesh's file
  double radius = 0;                    ///< reach along the surface, in units of length; above 0
  double strength = 1;  ///< on the line, in multiples of the pull of all neighbours; 0 to 1e6

  bool operator==(const FieldStroke&) const = default;
};

/// A soft constraint on the direction at a vertex.
struct FieldAnchor {
  Index vertex;
  Vec3 direction;    ///< any vector; the tangent part counts
  float weight = 1;  ///< in multiples of the pull of all neighbours
};

/// Throws Error for fewer than two points, a line without length, numbers that are not finite, a
/// radius that is not above zero and a strength out of range. The message names the first such
/// stroke (`strokes[2]`, counted from 0) and the remedy.
void check_strokes(std::span<const FieldStroke> strokes);

/// Soft constraints from strokes, for fields of even symmetry, because strokes are undirected. A
/// vertex is attracted to the mean direction, as a line, of the parts of a stroke within the radius
/// along the surface. At distance r the weight is strength (1 - (r / radius)^2)^2. Corners of
/// triangles under a stroke are attracted for any radius. Anchors of several strokes at one vertex
/// add up. Subdividing a stroke changes results only by rounding. Throws Error as `check_strokes`
/// does, and for a stroke farther from the surface than its radius and a hundredth of the surface's
/// diagonal, naming it and the distance; Cancelled if `progress` cancels.
std::vector<FieldAnchor> stroke_anchors(const Surface& surface,
                                        std::span<const FieldStroke> strokes,
                                        const Progress& progress = {});

/// Boundaries, edges of three or more triangles and edges where the surface bends by more than
/// `angle_deg` degrees, as strokes of this radius and strength, each from corner to corner. Throws
/// Cancelled if `progress` cancels.
std::vector<FieldStroke> feature_strokes(const Surface& surface, float angle_deg, double radius,
                                         double strength, const Progress& progress = {});

}  // namespace brindle
