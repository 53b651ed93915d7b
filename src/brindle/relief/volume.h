/// Volumes of closed meshes.
#pragma once

#include "brindle/mesh.h"

namespace brindle {

/// The volume inside a closed mesh that is wound outwards; negative if it is wound inwards.
double volume_of(const Mesh& mesh);

}  // namespace brindle
