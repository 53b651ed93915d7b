/// Texture coordinates at the corners of triangles.
#pragma once

#include <vector>

#include "brindle/phase_shift.h"
#include "brindle/texture_waves.h"

namespace brindle::python {

/// U and V of three corners per triangle, linear in each, one tile a unit; NaN in triangles that
/// are singularities of the field or have a corner without wave.
std::vector<float> corner_coordinates(const TextureWaves& waves, PhaseShiftKind kind);

}  // namespace brindle::python
