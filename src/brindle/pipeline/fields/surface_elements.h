/// Finite elements of surfaces with or without triangles: edge and vertex weights that make
/// smoothing independent of the mesh.
#pragma once

#include <span>
#include <vector>

#include "brindle/phase_graph.h"
#include "brindle/progress.h"
#include "brindle/surface.h"
#include "brindle/types.h"

namespace brindle {

/// One per directed edge: cotangents, bounded below so that obtuse angles do not decouple vertices.
/// For points, weights that give a constant gradient the energy of its area.
std::vector<float> edge_stiffness(const Surface& surface, const Progress& progress = {});

/// One per vertex: the sum over its edges.
std::vector<float> stiffness_sums(const Adjacency& adjacency, std::span<const float> stiffness);

/// A graph without rotation that couples vertex values by edge stiffness. Its anchors are empty.
PhaseGraph stiffness_graph(const Surface& surface, std::span<const float> stiffness);

std::vector<float> areas_of_triangles(const Mesh& mesh);

/// Vertex areas: a third of the adjacent triangles; for points, their share of the disc that the
/// neighbours fill.
std::vector<float> areas_of_vertices(const Surface& surface, std::span<const float> of_triangles);

}  // namespace brindle
