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

/// As `measure_texture` for texture waves, from their corner phases. The orientation of U and V in
/// a triangle has no effect.
TextureQuality measure_texture(const Mesh& mesh, const LinearPattern& u, const LinearPattern& v,
                               const Progress& progress = {});

}  // namespace brindle
