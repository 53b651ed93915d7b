/// Distortion of textures whose corner phases are known.
#pragma once

#include <span>

#include "brindle/corner_phases.h"
#include "brindle/progress.h"
#include "brindle/texture_waves.h"

namespace brindle {

/// One pattern of a texture: corner phases by triangle, frequencies by vertex.
struct LinearPattern {
  std::span<const CornerPhases> corners;
  std::span<const float> frequencies;
};

/// What `measure_texture` finds for texture waves with these corner phases. Which way U and V run
/// in a triangle makes no difference.
TextureQuality measure_texture(const Mesh& mesh, const LinearPattern& u, const LinearPattern& v,
                               const Progress& progress = {});

}  // namespace brindle
