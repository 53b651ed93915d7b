/// Surfaces with one visible side.
#pragma once

#include "brindle/mesh.h"

namespace brindle {

enum class HiddenSide { none, back, front };

/// The side of all triangles that is invisible from outside. It exists if the mesh is closed and
/// consistently wound, and the volumes of its connected components have the same sign. (Surfaces
/// that intersect themselves inside out are not detected.)
HiddenSide hidden_side(const Mesh& mesh);

}  // namespace brindle
