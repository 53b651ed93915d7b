/// Stripes and textures in both directions of a cross field (paper, 3.6).
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "brindle/cross_cover.h"
#include "brindle/export.h"
#include "brindle/mesh.h"
#include "brindle/phase_graph.h"
#include "brindle/stripe_pattern.h"
#include "brindle/texture_pattern.h"
#include "brindle/types.h"

namespace BRINDLE_EXPORT brindle {

struct CrossPattern {
  CrossCover cover;
  Surface surface;        ///< the cover as a surface: its nodes are vertices
  StripePattern pattern;  ///< on `surface`; its corners are those of `cover.triangles`

  /// Both waves together. `field_singularities` are triangles of the mesh around which the cross
  /// does not come back to itself unturned; `branches` counts such a triangle once for each wave.
  PatternQuality quality;
};

/// The cover as a surface, whose vertices are its nodes: on it a cross field is a line field, and
/// everything that works on surfaces works. `normals` are those of the covered surface's vertices.
Surface cover_surface(const CrossCover& cover, std::span<const Vec3> normals);

/// Matches the crosses that `waves` (one per vertex) and a quarter turn make along the edges of the
/// surface, and lays stripes along both their waves. Everything has 90-degree symmetry: turning any
/// vertex's direction by a quarter changes nothing but names. Throws what `stripe_pattern` throws.
CrossPattern cross_pattern(const Surface& surface, const WaveSet& waves,
                           const StripeOptions& options = {}, const Progress& progress = {});

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
                           PhaseShiftKind phase_shift = PhaseShiftKind::aligned,
                           const Progress& progress = {});

}  // namespace brindle
