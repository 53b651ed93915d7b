/// Anchors of strokes on a part of a surface.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "brindle/strokes.h"

namespace brindle {

/// The points that `stroke_anchors` projects onto the surface: the stroke's points, and the middles
/// of its equal steps.
std::vector<Eigen::Vector3d> places_of(const FieldStroke& stroke);

/// The largest allowed distance of these points from a surface with this bounding box diagonal.
double allowed_distance(const FieldStroke& stroke, double diagonal);

/// As `stroke_anchors` of strokes.h, for a part of a surface whose bounding box has this diagonal.
/// The part contains the triangles nearest to all points of the strokes, and those around vertices
/// within their radii of these triangles. With vertices and triangles in the order of the whole
/// surface, anchors have the same bits.
std::vector<FieldAnchor> stroke_anchors(const Surface& part, std::span<const FieldStroke> strokes,
                                        double diagonal, const Progress& progress = {});

/// Chains of mesh edges as strokes, each from corner to corner, as in `feature_strokes`.
std::vector<FieldStroke> strokes_along(const Mesh& mesh,
                                       const std::vector<std::array<Index, 2>>& edges,
                                       double radius, double strength,
                                       const Progress& progress = {});

}  // namespace brindle
