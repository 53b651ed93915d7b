/// A brush stroke across a surface, as constraints of the direction field.
#pragma once

#include <span>
#include <vector>

#include "brindle/smooth_field.h"
#include "brindle/surface.h"

namespace brindle {

/// A stroke along an edge path. Stripes below it run along it.
struct BrushStroke {
  std::vector<Vec3> path;           ///< smoothed points, one per vertex of the path
  std::vector<float> path_arc;      ///< of each point, from 0 to `length`
  float length = 0;                 ///< of the path, in units of length
  float radius = 0;                 ///< of the brush, along the surface
  std::vector<FieldAnchor> anchor;  ///< of every vertex below the complete stroke, at full strength
  std::vector<float> anchor_arc;    ///< the arc at which the brush reaches each of them
};

/// A stroke along the shortest edge path from the vertex with the smallest coordinate along the
/// bounding box's longest side to the farthest vertex. Empty if the surface has no triangle.
/// `radius` is above 0, `weight` is that of the anchors in the middle of the stroke.
BrushStroke make_brush_stroke(const Surface& surface, float radius, float weight);

/// The anchors when the brush is at `arc`, in units of length; full strength begins one radius
/// behind it. Overwrites `anchors`.
void anchors_up_to(const BrushStroke& stroke, float arc, std::vector<FieldAnchor>& anchors);

/// The position of the brush at `arc`. The stroke must not be empty.
Vec3 brush_tip(const BrushStroke& stroke, float arc);

}  // namespace brindle
