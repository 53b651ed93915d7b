/// The edges of a mesh, numbered, for jobs that cross them from triangle to triangle.
#pragma once

#include <array>
#include <cstddef>
#include <limits>
#include <vector>

#include "brindle/mesh.h"
#include "brindle/progress.h"
#include "brindle/types.h"

namespace brindle {

/// In place of a triangle that is not there.
inline constexpr Index kNoTriangle = std::numeric_limits<Index>::max();

/// The edges of a mesh of any topology, each once, however many triangles share it. Edge m of a
/// triangle runs from corner m to the next one.
struct MeshEdges {
  std::vector<std::array<Index, 2>> vertices;     ///< the two ends, the lower number first
  std::vector<Index> triangle_counts;             ///< of every edge: 1 at a boundary, 2 inside
  std::vector<std::array<Index, 3>> of_triangle;  ///< the numbers of every triangle's edges
  /// For every triangle and each of its edges, which of the edge's triangles this is: 0, 1, ...
  std::vector<std::array<Index, 3>> ranks;

  std::size_t count() const { return vertices.size(); }
};

/// `neighborhood` is the mesh's own (`vertex_neighborhood`). Edges are in ascending order of their
/// higher vertex, then of their lower one.
MeshEdges mesh_edges(const Mesh& mesh, const Adjacency& neighborhood,
                     const Progress& progress = {});

/// The first two triangles of every edge; `kNoTriangle` where there is but one.
std::vector<std::array<Index, 2>> triangles_of_edges(const MeshEdges& edges,
                                                     const Progress& progress = {});

}  // namespace brindle
