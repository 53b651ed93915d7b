/// Noise on meshes.
#pragma once

#include <cstdint>

#include "brindle/mesh.h"
#include "brindle/progress.h"

namespace brindle {

/// Moves each vertex along its normal by a random distance, uniform within +-amplitude times the
/// mean edge length. The same seed gives the same mesh. Throws Error if the amplitude is not
/// finite, and Cancelled.
void add_noise(Mesh& mesh, float amplitude, std::uint32_t seed = 1, const Progress& progress = {});

}  // namespace brindle
