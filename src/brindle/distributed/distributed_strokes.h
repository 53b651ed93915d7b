/// What strokes ask of a surface that is seen with other normals.
#pragma once

#include <span>
#include <vector>

#include "brindle/distributed_surface.h"

namespace brindle {

/// Collective. As that of the surface's own normals; `normals` has those of all vertices of the
/// rank's surface.
std::vector<FieldAnchor> stroke_anchors(const DistributedSurface& surface,
                                        std::span<const FieldStroke> strokes,
                                        std::span<const Vec3> normals);

}  // namespace brindle
