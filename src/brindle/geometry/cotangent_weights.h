/// Edge weights from the shape of the triangles.
#pragma once

#include <vector>

#include "brindle/mesh.h"
#include "brindle/progress.h"
#include "brindle/types.h"

namespace brindle {

/// c for every directed edge of `neighborhood`: half the sum of the cotangents of the angles
/// opposite the edge (Pinkall and Polthier 1993), taken over all its triangles; between 0, where
/// angles are obtuse, and 10, where slivers would drown the rest. `neighborhood` is that of `mesh`,
/// or has some of its rows.
std::vector<float> edge_cotangents(const Mesh& mesh, const Adjacency& neighborhood,
                                   const Progress& progress = {});

/// 1/2 + c: the constant keeps edges across obtuse angles alive.
std::vector<float> cotangent_weights(const Mesh& mesh, const Adjacency& neighborhood,
                                     const Progress& progress = {});

}  // namespace brindle
