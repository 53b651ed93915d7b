/// Triangle meshes of implicit surfaces.
#pragma once

#include <functional>

#include <Eigen/Core>

#include "brindle/mesh.h"
#include "brindle/progress.h"

namespace brindle {

/// Negative inside, positive outside, and nowhere steeper than 1: a signed distance, or a smooth
/// minimum or maximum of signed distances.
using ImplicitFunction = std::function<double(const Eigen::Vector3d&)>;

/// The surface where `function` is 0 as a closed manifold, wound outwards, of near-equilateral
/// triangles with edges of about `edge_length`. The surface must lie within `box`; parts of it that
/// are thinner than `edge_length` may get lost.
///
/// A body-centred cubic lattice of tetrahedra whose vertices are snapped to near crossings
/// (Labelle and Shewchuk 2007, Isosurface Stuffing) gives the topology; Delaunay flips and
/// relaxation in the tangent planes give the triangles their shape.
///
/// Throws Error if the surface leaves the box, or the box holds too many cells; TooLarge (memory.h)
/// for a surface that memory does not hold, before it is begun; Cancelled if `progress` asks for
/// it.
Mesh isosurface(const ImplicitFunction& function, const BoundingBox& box, float edge_length,
                const Progress& progress = {});

}  // namespace brindle
