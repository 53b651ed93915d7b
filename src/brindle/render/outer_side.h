/// Surfaces that show one of their sides alone.
#pragma once

#include "brindle/mesh.h"

namespace brindle {

enum class HiddenSide { none, back, front };

/// The side of all triangles that nobody outside sees: one is hidden if the mesh is closed, its
/// triangles are wound alike, and connected parts all enclose positive, or all negative, volumes.
/// (Unless it passes through itself and turns itself inside out.)
HiddenSide hidden_side(const Mesh& mesh);

}  // namespace brindle
