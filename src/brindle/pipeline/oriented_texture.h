/// From two stripe patterns to a texture.
#pragma once

#include "brindle/mesh.h"
#include "brindle/progress.h"
#include "brindle/texture_pattern.h"

namespace brindle {

/// Orients the triangles, unless directions are vectors `as_given`, and fills in waves, seams and
/// quality from both patterns, whatever phases these have.
void orient_texture(const Mesh& mesh, bool as_given, const Progress& progress,
                    TexturePattern& pattern);

}  // namespace brindle
