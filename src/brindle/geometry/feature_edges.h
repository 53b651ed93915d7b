/// Sharp edges and boundaries.
#pragma once

#include <array>
#include <vector>

#include "brindle/geometry/topology.h"
#include "brindle/mesh.h"

namespace brindle {

/// The two ends of every edge that lies on a boundary, has more than two triangles, or between
/// whose triangles the surface bends by more than `angle_deg` degrees (0: flat; however they are
/// wound). `edges` are those of the mesh.
std::vector<std::array<Index, 2>> feature_edges(const Mesh& mesh, const MeshEdges& edges,
                                                float angle_deg, const Progress& progress = {});

}  // namespace brindle
