/// What is refused of a piece of a surface.
#pragma once

#include "brindle/distributed_surface.h"

namespace brindle {

/// Throws Error for a piece whose lists do not fit together, as `make_surface` refuses meshes, and
/// for two vertices of one number. Says nothing of other ranks.
void check_piece(const SurfacePiece& piece);

}  // namespace brindle
