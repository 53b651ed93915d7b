/// Rough versions of smooth meshes.
#pragma once

#include <cstdint>

#include "brindle/mesh.h"

namespace brindle {

/// Moves every vertex along its normal by a random distance, uniform between -amplitude and
/// +amplitude times the mean edge length. The same seed gives the same mesh.
/// Throws Error if the amplitude is not finite.
void add_noise(Mesh& mesh, float amplitude, std::uint32_t seed = 1);

}  // namespace brindle
