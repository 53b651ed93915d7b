/// Triangles that stand twice.
#pragma once

#include <vector>

#include "brindle/mesh.h"

namespace brindle {

/// Of every triangle the first that has the same corners, in whatever order: itself for all but
/// repeated ones.
std::vector<Index> first_with_same_corners(const Mesh& mesh);

}  // namespace brindle
