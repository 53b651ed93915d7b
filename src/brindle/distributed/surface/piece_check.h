/// Validates partitions.
#pragma once

#include "brindle/distributed_surface.h"

namespace brindle {

/// Throws Error for inconsistent lists, as `make_surface` does for meshes, and for repeated vertex
/// numbers. Checks one rank only.
void check_piece(const SurfacePiece& piece);

}  // namespace brindle
