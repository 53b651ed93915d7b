/// Small figures that stand at samples and show what is there.
#pragma once

#include <span>
#include <vector>

#include "brindle/export.h"
#include "brindle/mesh.h"
#include "brindle/progress.h"
#include "brindle/samples.h"
#include "brindle/texture_waves.h"

namespace BRINDLE_EXPORT brindle {

enum class GlyphShape {
  disc,     ///< flat, round
  arrow,    ///< along the first direction
  ellipse,  ///< a flattened ellipsoid whose axes are the two directions: a tensor's
  stroke,   ///< a brush's, along the second direction: flat, and not cut off at the silhouette
  quad      ///< flat, for a picture, whose upper side is towards the second direction
};

/// How large one glyph is, in units of length; nothing is drawn where a number is none or not above
/// zero.
struct GlyphSize {
  float along = 0;   ///< the first direction
  float across = 0;  ///< the second direction
};

/// Glyphs, and which sample each vertex belongs to.
struct Glyphs {
  Mesh mesh;
  std::vector<Vec3> normals;  ///< one unit normal per vertex
  std::vector<Index> sample_of_vertex;
  TextureWaves waves;  ///< of quads: one tile of a RegionTexture fills each
};

/// Sizes that leave gaps between neighbours: `share` of the sample's spacings, times a factor for
/// each sample if there are any.
std::vector<GlyphSize> glyph_sizes(std::span<const Sample> samples, float share,
                                   std::span<const float> factors = {});

/// A glyph at every sample, just above the side that normals point to; flat ones below, too, as
/// surfaces may be wound either way. Sizes have an entry per sample. Throws Error if they have not,
/// if there would be more vertices than an Index can count, and, before any is made, for more than
/// memory holds, naming how many it does; Cancelled if `progress` asks for it.
Glyphs glyphs_at(std::span<const Sample> samples, GlyphShape shape,
                 std::span<const GlyphSize> sizes, const Progress& progress = {});

}  // namespace brindle
