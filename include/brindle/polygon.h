/// Polygons cut into triangles.
#pragma once

#include <span>
#include <vector>

#include "brindle/export.h"
#include "brindle/mesh.h"

namespace BRINDLE_EXPORT brindle {

/// Appends the triangles of a polygon, wound as it is, to `triangles`: n - 2 for n corners, none
/// for fewer than 3. Quadrangles are cut along their shorter inner diagonal, others by ear clipping
/// in the plane of the polygon's mean normal. Polygons of more than 1000 corners are taken as
/// convex. All of Brindle cuts polygons so. `corners` are numbers of `positions`.
void triangulate_polygon(std::span<const Vec3> positions, std::span<const Index> corners,
                         std::vector<Triangle>& triangles);

}  // namespace brindle
