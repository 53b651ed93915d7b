/// Stripes in both directions of a cross field (paper, 3.6).
#pragma once

#include "brindle/pipeline/stripe_pattern.h"
#include "brindle/waves/cross_cover.h"

namespace brindle {

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

}  // namespace brindle
