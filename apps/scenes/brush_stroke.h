/// A brush drawn across a surface: what it asks of the direction field on its way.
#pragma once

#include <span>
#include <vector>

#include "brindle/smooth_field.h"
#include "brindle/surface.h"

namespace brindle {

/// A stroke along a path over edges. Stripes under it run along it.
struct BrushStroke {
  std::vector<Vec3> path;           ///< smoothed points, one per vertex of the path
  std::vector<float> path_arc;      ///< of each point, from 0 to `length`
  float length = 0;                 ///< of the path, in units of length
  float radius = 0;                 ///< of the brush, along the surface
  std::vector<FieldAnchor> anchor;  ///< of every vertex under the finished stroke, in full strength
  std::vector<float> anchor_arc;    ///< the arc at which the brush reaches each of them
};

/// A stroke along the shortest way over edges from the vertex with the smallest coordinate along
/// the bounding box's longest side to the vertex that is farthest from it. Empty if the surface has
/// no triangle. `radius` is above 0, `weight` that of the anchors in the middle of the stroke.
BrushStroke make_brush_stroke(const Surface& surface, float radius, float weight);

/// The anchors once the brush has come to `arc`, in units of length; it leaves full strength one
/// radius behind it. `anchors` is overwritten.
void anchors_up_to(const BrushStroke& stroke, float arc, std::vector<FieldAnchor>& anchors);

/// Where the brush is when it has come to `arc`. The stroke must not be empty.
Vec3 brush_tip(const BrushStroke& stroke, float arc);

}  // namespace brindle
