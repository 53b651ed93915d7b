/// Edges of closed manifold meshes turned so that triangles get better angles.
#pragma once

#include <vector>

#include "brindle/mesh.h"
#include "brindle/progress.h"

namespace brindle {

/// Flips edges until every one is locally Delaunay (the angles opposite it add up to at most 180
/// degrees), or `rounds` passes are done. An edge stays if its flip would double another edge or
/// fold the surface over. `twins` are those of the mesh (`manifold_twins`), and stay so. Where
/// `progress` throws, some edges are flipped.
void flip_to_delaunay(Mesh& mesh, std::vector<Index>& twins, int rounds,
                      const Progress& progress = {});

}  // namespace brindle
