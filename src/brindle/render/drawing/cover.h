/// Whether strokes of a style, or motifs of a texture's tiles, cover a point.
#pragma once

#include <array>
#include <cstddef>
#include <optional>

#include "brindle/styled_picture.h"

namespace brindle {

/// A visible point of a triangle.
struct SeenPoint {
  const StyledSurface* surface = nullptr;
  std::size_t number = 0;  ///< of the surface, among all
  std::size_t triangle = 0;
  Vec3 barycentric = Vec3::Zero();
  /// The same half a step to the right, left, below and above in the picture; weights may be
  /// slightly negative.
  std::array<Vec3, 4> beside{};
  float step = 1;  ///< pixels
};

/// The layer that covers a point of a surface.
enum class Cover {
  plain,   ///< no pattern: no wave, or no value for the strokes
  ground,  ///< between strokes
  stroke
};

/// Twin of strokes.glsl with stripe_middle.glsl: the same ends of stripes, but unfiltered. `tone`
/// is the lightness of the surface there, 0 to 1.
Cover cover_at(const SeenPoint& point, float tone);

/// Whether strokes of the surface depend on the light.
bool follows_tone(const StyledSurface& surface);

/// Whether region borders depend on the pixel grid: each tile takes the value in its middle.
bool follows_values(const RegionTexture& texture);

/// The tile of the texture whose motif covers the point; empty if none does. Twin of
/// region_texture.glsl for unfiltered built-in tiles; picture tiles have no motif.
std::optional<std::size_t> tile_at(const SeenPoint& point);

}  // namespace brindle
