/// Finer meshes of the same surface.
#pragma once

#include "brindle/geometry/mesh.h"

namespace brindle {

/// Splits every triangle in four at the midpoints of its edges, `times` times. Triangles that share
/// an edge, however many, share its midpoint. Old vertices keep their numbers; the midpoints
/// follow, ordered by the numbers of their edge's ends. The triangles of triangle t are 4 t .. 4 t
/// + 3, the inner one last. Throws Error if `times` is negative, or the result would have more
/// triangles than brindle can number.
Mesh subdivide(Mesh mesh, int times = 1);

}  // namespace brindle
