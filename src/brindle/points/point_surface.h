/// A point cloud as a surface without triangles.
#pragma once

#include "brindle/geometry/surface.h"
#include "brindle/points/point_cloud.h"

namespace brindle {

/// Joins every point to its `neighbors` nearest and, if the cloud has no normals, fits and orients
/// them. Points that are not used, and those whose neighbours lie on a line, have a zero normal and
/// so carry no wave. Everything that works on a Surface works on the result, from direction fields
/// to `stripe_pattern`; what needs triangles finds none. Throws Error if no point has a normal, and
/// what `point_neighborhood` throws.
Surface make_point_surface(PointCloud cloud, int neighbors = 8);

}  // namespace brindle
