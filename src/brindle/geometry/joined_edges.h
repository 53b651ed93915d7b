/// The edges of a surface as they were before creases split it.
#pragma once

#include "brindle/geometry/topology.h"
#include "brindle/surface.h"

namespace brindle {

/// The edges of a surface whose vertices were not split at creases, in the numbers of that time:
/// an edge on a crease has two triangles, whose corners there may be copies of its ends.
MeshEdges joined_edges(const Surface& surface, const Progress& progress = {});

}  // namespace brindle
