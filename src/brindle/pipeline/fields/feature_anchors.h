/// Smooth fields drawn to sharp edges and boundaries, at these alone.
#pragma once

#include <span>

#include "brindle/mesh.h"
#include "brindle/phase_graph.h"
#include "brindle/smooth_field.h"
#include "brindle/types.h"

namespace brindle {

/// Adds the pull of features to the graph's anchors. Its nodes are the first vertices of the mesh,
/// whose own neighbourhood and normals these are; those whose row in the graph is empty may lack
/// triangles, and are not drawn.
void add_feature_anchors(PhaseGraph& graph, const Mesh& mesh, const Adjacency& neighborhood,
                         std::span<const Vec3> normals, const SmoothFieldOptions& options);

}  // namespace brindle
