/// The edges of a surface before it was split at creases.
#pragma once

#include "brindle/geometry/topology.h"
#include "brindle/surface.h"

namespace brindle {

/// The edges of a surface before its vertices were split at creases, with the original numbers. An
/// edge on a crease has two triangles, whose corners may be copies of its ends.
MeshEdges joined_edges(const Surface& surface, const Progress& progress = {});

}  // namespace brindle
