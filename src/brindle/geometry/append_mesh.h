/// Several meshes as one.
#pragma once

#include "brindle/mesh.h"

namespace brindle {

/// Adds all vertices and triangles of `other` behind those of `mesh`, whose origin stays
/// unless it is empty.
void append(const Mesh& other, Mesh& mesh);

}  // namespace brindle
