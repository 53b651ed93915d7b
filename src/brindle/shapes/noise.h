/// Rough versions of smooth meshes.
#pragma once

#include <cstdint>

#include "brindle/mesh.h"
#include "brindle/progress.h"

namespace brindle {

/// Moves every vertex along its normal by a random distance, uniform between -amplitude and
/// +amplitude times the mean edge length. The same seed gives the same mesh.
/// Throws Error if the amplitude is not finite, and Cancelled if `progress` asks for it.
void add_noise(Mesh& mesh, float amplitude, std::uint32_t seed = 1, const Progress& progress = {});

}  // namespace brindle
