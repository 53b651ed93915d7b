/// Decimation of meshes by edge collapses.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "brindle/mesh.h"
#include "brindle/progress.h"

namespace brindle {

/// The mesh without vertices that its shape does not need: a vertex moves onto a neighbour while
/// that one is within the tolerance of the planes of all triangles that were at the vertex (error
/// quadrics, Garland and Heckbert 1997). Closed and wound meshes stay so, and no triangle turns
/// over. Vertices with a 1 in `locked` stay, and so do those on boundaries. The triangles and
/// vertices left keep their order. Throws Cancelled if `progress` cancels.
Mesh decimated(const Mesh& mesh, std::span<const std::uint8_t> locked, float tolerance,
               const Progress& progress = {});

}  // namespace brindle
