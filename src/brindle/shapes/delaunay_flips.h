/// Delaunay flips on closed manifold meshes.
#pragma once

#include <vector>

#include "brindle/mesh.h"
#include "brindle/progress.h"

namespace brindle {

/// Flips edges until each is locally Delaunay (opposite angles of at most 180 degrees in total),
/// for at most `rounds` passes. Skips flips that would duplicate an edge or fold the surface.
/// Maintains `twins`, those of the mesh (`manifold_twins`). Exceptions of `progress` leave some
/// edges flipped.
void flip_to_delaunay(Mesh& mesh, std::vector<Index>& twins, int rounds,
                      const Progress& progress = {});

}  // namespace brindle
