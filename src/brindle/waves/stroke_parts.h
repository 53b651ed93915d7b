/// Strokes on a part of a surface.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "brindle/strokes.h"

namespace brindle {

/// What `stroke_anchors` looks for on the surface: the stroke's points, and the middles of the
/// equal steps that it is divided into.
std::vector<Eigen::Vector3d> places_of(const FieldStroke& stroke);

/// How far from the surface these may be, if its bounding box has this diagonal.
double allowed_distance(const FieldStroke& stroke, double diagonal);

/// As `stroke_anchors` of strokes.h, for a surface whose bounding box has this diagonal and of
/// which only a part is there: the triangles nearest to all places of the strokes, and those around
/// vertices within their radii of these triangles. With the same order of vertices and triangles as
/// in the whole, anchors have the same bits.
std::vector<FieldAnchor> stroke_anchors(const Surface& part, std::span<const FieldStroke> strokes,
                                        double diagonal, const Progress& progress = {});

/// Edges of a mesh as strokes, each from corner to corner: what `feature_strokes` makes of feature
/// edges.
std::vector<FieldStroke> strokes_along(const Mesh& mesh,
                                       const std::vector<std::array<Index, 2>>& edges,
                                       double radius, double strength,
                                       const Progress& progress = {});

}  // namespace brindle
