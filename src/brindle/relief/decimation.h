/// Decimation of meshes by edge collapses.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "brindle/mesh.h"
#include "brindle/progress.h"

namespace brindle {

/// The triangles of a mesh without vertices that its shape does not need, numbered as before. A
/// vertex moves onto a neighbour while that one is within the tolerance of the planes of all
/// triangles that were at the vertex (error quadrics, Garland and Heckbert 1997). Closed and wound
/// meshes stay so. No triangle turns over, neither in the mesh nor at `rest`, the places of its
/// vertices before they were displaced: a mesh that lies over a surface like a map stays one.
/// Vertices with a 1 in `locked` stay, and so do those on boundaries. Triangles keep their order.
/// Throws Cancelled if `progress` cancels.
std::vector<Triangle> decimated(const Mesh& mesh, std::span<const Vec3> rest,
                                std::span<const std::uint8_t> locked, float tolerance,
                                const Progress& progress = {});

}  // namespace brindle
