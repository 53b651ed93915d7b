/// The neighbourhood N(i) of every vertex, from triangles of any topology.
#pragma once

#include "brindle/geometry/topology.h"
#include "brindle/mesh.h"
#include "brindle/progress.h"
#include "brindle/types.h"

namespace brindle {

/// Two vertices are neighbours if a triangle has them both. An edge that any number of triangles
/// share counts once; vertices without a triangle have no neighbours.
Adjacency vertex_neighborhood(const Mesh& mesh, const Progress& progress = {});

/// The same, with what `vertex_triangles` found.
Adjacency vertex_neighborhood(const Mesh& mesh, const VertexTriangles& around,
                              const Progress& progress = {});

}  // namespace brindle
