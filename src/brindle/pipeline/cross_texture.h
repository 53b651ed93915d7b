/// Textures with 90-degree symmetry along both waves of a cross field (paper, 3.6).
#pragma once

#include "brindle/pipeline/cross_pattern.h"
#include "brindle/pipeline/texture_pattern.h"

namespace brindle {

/// What a texture is drawn on.
struct CrossTexture {
  /// The surface with every singular triangle split at its barycentre: triangles around which
  /// crosses match come first (`cover.base`), then three for each of `cover.singular`. New vertices
  /// stand behind those of the surface and have no wave of their own.
  Surface surface;

  /// `u` holds the waves (i, 0), `v` the waves (i, 1); their corners, one entry per triangle, are
  /// those of U and V there, whichever of the two waves that is at a vertex. Both have the energy
  /// and the quality of the whole cross pattern. There are no seams for a tile that looks the same
  /// turned by 90 degrees: `seams` is not filled.
  TexturePattern pattern;
};

/// Gives every triangle waves U and V. In a singular triangle each of the three parts matches the
/// crosses along its own edge, so that it fits its neighbour there; between the parts, inside the
/// triangle, the texture turns. V runs to the left of U everywhere, seen from outside.
CrossTexture cross_texture(const Surface& surface, const CrossPattern& cross,
                           PhaseShiftKind phase_shift = PhaseShiftKind::aligned);

}  // namespace brindle
