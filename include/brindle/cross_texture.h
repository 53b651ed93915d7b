/// Stripes and textures in both directions of a cross field (paper, 3.6).
#pragma once

#include <span>

#include "brindle/cross_cover.h"
#include "brindle/export.h"
#include "brindle/mesh.h"
#include "brindle/phase_graph.h"
#include "brindle/stripe_pattern.h"
#include "brindle/texture_pattern.h"
#include "brindle/types.h"

namespace BRINDLE_EXPORT brindle {

/// A stripe pattern along both waves of a cross field.
struct CrossPattern {
  CrossCover cover;
  Surface surface;        ///< the cover as a surface: its nodes are vertices
  StripePattern pattern;  ///< on `surface`; its corners are those of `cover.triangles`

  /// Of both waves together. `field_singularities` are triangles of the mesh around which the cross
  /// does not return to itself unturned; `branches` counts each once per wave.
  PatternQuality quality;
};

/// The cover as a surface, whose vertices are its nodes. On it a cross field is a line field, so
/// all functions for surfaces apply. `normals` are those of the covered surface's vertices.
Surface cover_surface(const CrossCover& cover, std::span<const Vec3> normals);

/// Matches the crosses that `waves` (one per vertex) and their quarter turns form along the edges,
/// and lays stripes along both waves. The result has 90-degree symmetry: a quarter turn of any
/// vertex's direction only renames waves. Throws what `check_tangent_waves` and `stripe_pattern`
/// throw.
CrossPattern cross_pattern(const Surface& surface, const WaveSet& waves,
                           const StripeOptions& options = {}, const Progress& progress = {});

/// A texture along both waves of a cross field.
struct CrossTexture {
  /// The surface with every singular triangle split at its barycentre. Triangles around which
  /// crosses match come first (`cover.base`), then three for each of `cover.singular`. New vertices
  /// follow those of the surface and have no wave of their own.
  Surface surface;

  /// `u` holds the waves (i, 0), `v` the waves (i, 1). Their corners, one entry per triangle, are
  /// those of U and V, either of which may be either wave of a vertex. Both have the energy and the
  /// quality of the whole cross pattern. `seams` is not filled: tiles with 90-degree symmetry have
  /// none.
  TexturePattern pattern;
};

/// Assigns waves U and V to every triangle. In a singular triangle, each of the three parts matches
/// the crosses along its own edge, and so fits its neighbour; between the parts the texture turns.
/// V runs to the left of U everywhere, seen from outside.
CrossTexture cross_texture(const Surface& surface, const CrossPattern& cross,
                           PhaseShiftKind phase_shift = PhaseShiftKind::aligned,
                           const Progress& progress = {});

}  // namespace brindle
