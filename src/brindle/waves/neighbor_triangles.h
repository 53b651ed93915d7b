/// Triangles between neighbours, for what has none of its own.
#pragma once

#include <span>
#include <vector>

#include "brindle/mesh.h"
#include "brindle/progress.h"
#include "brindle/types.h"

namespace brindle {

/// Around every point with a normal, it and each two neighbours that follow each other, seen along
/// the normal, at an angle below 120 degrees; every triangle once, whoever it was found around.
/// They overlap, and edges between neighbours need not be edges of the neighbourhood.
std::vector<Triangle> neighbor_triangles(std::span<const Vec3> positions,
                                         std::span<const Vec3> normals,
                                         const Adjacency& neighborhood,
                                         const Progress& progress = {});

}  // namespace brindle
