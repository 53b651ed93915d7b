/// Edges of a surface at its creases.
#pragma once

#include "brindle/geometry/topology.h"
#include "brindle/surface.h"

namespace brindle {

/// The edges of a surface before its vertices were split at creases, with the original numbers. An
/// edge on a crease has two triangles, whose corners may be copies of its ends.
MeshEdges joined_edges(const Surface& surface, const Progress& progress = {});

/// Whether an edge is sharp enough for a crease or has three or more triangles. If not, no part of
/// the mesh is split. Throws as `split_at_creases` does.
bool may_have_creases(const Mesh& mesh, float angle_deg);

}  // namespace brindle
