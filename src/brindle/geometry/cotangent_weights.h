/// Edge weights from the shape of the triangles.
#pragma once

#include <vector>

#include "brindle/adjacency.h"
#include "brindle/mesh.h"
#include "brindle/progress.h"

namespace brindle {

/// 1/2 + max(c, 0) for every directed edge of `neighborhood`, c half the sum of the cotangents of
/// the angles opposite the edge (Pinkall and Polthier 1993), taken over all its triangles. Never
/// negative: the constant keeps edges across obtuse angles alive. c is cut off at 10, where slivers
/// would drown the rest. `neighborhood` is that of `mesh`, or has some of its rows.
std::vector<float> cotangent_weights(const Mesh& mesh, const Adjacency& neighborhood,
                                     const Progress& progress = {});

}  // namespace brindle
