/// Finite elements of a surface with or without triangles: what edges and vertices count, so that
/// what is smoothed does not depend on the mesh.
#pragma once

#include <span>
#include <vector>

#include "brindle/phase_graph.h"
#include "brindle/progress.h"
#include "brindle/surface.h"
#include "brindle/types.h"

namespace brindle {

/// One per directed edge: cotangents, small ones where angles are obtuse, so that nothing falls
/// apart; between points such that the energy of a field with an even gradient is that of its area.
std::vector<float> edge_stiffness(const Surface& surface, const Progress& progress = {});

/// One per vertex: the sum over its edges.
std::vector<float> stiffness_sums(const Adjacency& adjacency, std::span<const float> stiffness);

/// Numbers at vertices, coupled by the stiffness of their edges: a graph that turns nothing. Its
/// anchors are still to be set.
PhaseGraph stiffness_graph(const Surface& surface, std::span<const float> stiffness);

std::vector<float> areas_of_triangles(const Mesh& mesh);

/// What every vertex stands for: a third of its triangles, or, of points, its share of the disc
/// that its neighbours fill.
std::vector<float> areas_of_vertices(const Surface& surface, std::span<const float> of_triangles);

}  // namespace brindle
