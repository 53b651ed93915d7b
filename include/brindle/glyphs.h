/// Glyphs: small meshes at samples that show local values.
#pragma once

#include <span>
#include <vector>

#include "brindle/export.h"
#include "brindle/mesh.h"
#include "brindle/progress.h"
#include "brindle/samples.h"
#include "brindle/texture_waves.h"

namespace BRINDLE_EXPORT brindle {

/// Shapes of glyphs.
enum class GlyphShape {
  disc,     ///< flat, round
  arrow,    ///< along the first direction
  ellipse,  ///< a flattened ellipsoid with the two directions as axes, for tensors
  stroke,   ///< a brush stroke along the second direction: flat, not cut off at the silhouette
  quad      ///< flat, for a picture whose upper side is towards the second direction
};

/// The size of one glyph, in units of length. Sizes that are NaN or not above zero draw nothing.
struct GlyphSize {
  float along = 0;   ///< the first direction
  float across = 0;  ///< the second direction
};

/// Glyphs, and the sample that each vertex belongs to.
struct Glyphs {
  Mesh mesh;
  std::vector<Vec3> normals;  ///< one unit normal per vertex
  std::vector<Index> sample_of_vertex;
  TextureWaves waves;  ///< of quads: one tile of a RegionTexture fills each
};

/// Sizes that leave gaps between neighbours: `share` of the sample's spacings, times the sample's
/// factor if given.
std::vector<GlyphSize> glyph_sizes(std::span<const Sample> samples, float share,
                                   std::span<const float> factors = {});

/// A glyph at every sample, just above the side that normals point to. Flat glyphs are on both
/// sides, since surfaces may be wound either way. Throws Error unless there is one size per sample,
/// and for more vertices than an Index can count. Before any is made, throws Error for more glyphs
/// than fit in memory, naming a number that does. Throws Cancelled if `progress` cancels.
Glyphs glyphs_at(std::span<const Sample> samples, GlyphShape shape,
                 std::span<const GlyphSize> sizes, const Progress& progress = {});

}  // namespace brindle
