/// Half-edges of closed manifold meshes, for jobs that change connectivity.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "brindle/mesh.h"
#include "brindle/progress.h"

namespace brindle {

/// Half-edge 3 t + c runs from corner c of triangle t to its next corner. `twins` has for each one
/// the half-edge that runs back along the same edge.
struct HalfEdges {
  std::vector<Index> twins;

  static Index next(Index half_edge) { return half_edge % 3 == 2 ? half_edge - 2 : half_edge + 1; }
  static Index previous(Index half_edge) {
    return half_edge % 3 == 0 ? half_edge + 2 : half_edge - 1;
  }
  static Index origin(const Mesh& mesh, Index half_edge) {
    return mesh.triangles[half_edge / 3][half_edge % 3];
  }
};

/// Nothing if the mesh is not a closed, consistently wound manifold: every edge has two triangles,
/// and the triangles of every vertex form one fan.
std::optional<HalfEdges> half_edges(const Mesh& mesh, const Progress& progress = {});

/// Flips edges until every one is locally Delaunay (the angles opposite of it add up to 180 degrees
/// at most), or `rounds` passes are done. An edge stays if its flip would double another edge or
/// fold the surface over. Where `progress` throws, some edges are flipped.
void flip_to_delaunay(Mesh& mesh, HalfEdges& edges, int rounds = 10, const Progress& progress = {});

}  // namespace brindle
