/// Strokes: lines drawn near a surface, which its smooth direction field follows.
#pragma once

#include <span>
#include <vector>

#include "brindle/export.h"
#include "brindle/progress.h"
#include "brindle/surface.h"
#include "brindle/types.h"

namespace BRINDLE_EXPORT brindle {

/// A line near a surface and how it draws the field. It stands in space, not on vertices: it stays
/// what it is when the mesh is refined, moved by its origin or exchanged. It has no sense: read
/// backwards it is the same stroke.
struct FieldStroke {
  std::vector<Eigen::Vector3d> points;  ///< two or more, in the coordinates of the mesh's file
  double radius = 0;    ///< how far from the line it draws, in units of length; above 0
  double strength = 1;  ///< on the line, in multiples of what all neighbours of a vertex pull
                        ///< together; 0 or above

  bool operator==(const FieldStroke&) const = default;
};

/// Pulls the field at a vertex towards a direction.
struct FieldAnchor {
  Index vertex;
  Vec3 direction;    ///< any vector; its tangent part counts
  float weight = 1;  ///< in multiples of what all neighbours together pull
};

/// Throws Error, naming the first stroke (`strokes[2]`, counted from 0) and what to do, for fewer
/// than two points, a line without length, numbers that are not finite, a radius that is not above
/// zero and a strength below zero.
void check_strokes(std::span<const FieldStroke> strokes);

/// What strokes ask of a smooth field, for fields of an even symmetry: lines have no sign. A vertex
/// is drawn to the mean direction, as lines, of what a stroke has nearer to it than the radius
/// along the surface; at distance r from the line by strength (1 - (r / radius)^2)^2. Corners of
/// triangles that a stroke runs over are drawn however small its radius is. Anchors of several
/// strokes at one vertex add up. Throws Error as `check_strokes` does, and for a stroke that is
/// farther from the surface than its radius (and than a hundredth of the surface's diagonal),
/// naming it and the distance; Cancelled if `progress` asks for it. Nothing depends on how a stroke
/// is divided, but for rounding.
std::vector<FieldAnchor> stroke_anchors(const Surface& surface,
                                        std::span<const FieldStroke> strokes,
                                        const Progress& progress = {});

/// Boundaries, edges of three triangles or more and edges where the surface bends by more than
/// `angle_deg`, as strokes of this radius and strength, each from corner to corner. Throws
/// Cancelled if `progress` asks for it.
std::vector<FieldStroke> feature_strokes(const Surface& surface, float angle_deg, double radius,
                                         double strength, const Progress& progress = {});

}  // namespace brindle
