/// Triangle meshes of implicit surfaces.
#pragma once

#include <functional>

#include <Eigen/Core>

#include "brindle/mesh.h"
#include "brindle/progress.h"

namespace brindle {

/// Negative inside, positive outside, with slopes of at most 1: a signed distance, or a smooth
/// minimum or maximum of signed distances.
using ImplicitFunction = std::function<double(const Eigen::Vector3d&)>;

/// The zero set of `function` as a closed manifold, wound outwards, of near-equilateral triangles
/// with edges of about `edge_length`. It must be within `box`; parts thinner than `edge_length` may
/// be lost.
///
/// The topology comes from a body-centred cubic lattice whose points are snapped to near crossings
/// (Labelle and Shewchuk 2007, Isosurface Stuffing); Delaunay flips and tangential relaxation
/// improve the triangles.
///
/// Throws Error if the surface leaves the box or the box has too many cells; TooLarge (memory.h),
/// before it starts, for a surface beyond the memory limit; Cancelled.
Mesh isosurface(const ImplicitFunction& function, const BoundingBox& box, float edge_length,
                const Progress& progress = {});

}  // namespace brindle
