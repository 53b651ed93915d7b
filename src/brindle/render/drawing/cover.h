/// Whether strokes of a style, or figures of a texture's tiles, cover a point.
#pragma once

#include <array>
#include <cstddef>
#include <optional>

#include "brindle/styled_picture.h"

namespace brindle {

/// A point of a triangle that is seen in a picture.
struct SeenPoint {
  const StyledSurface* surface = nullptr;
  std::size_t number = 0;  ///< of the surface
  std::size_t triangle = 0;
  Vec3 barycentric = Vec3::Zero();
  /// The same half a step farther to the right, to the left, down and up in the picture; weights
  /// may be a little below zero.
  std::array<Vec3, 4> beside{};
  float step = 1;  ///< pixels
};

/// What covers a point of a surface.
enum class Cover {
  plain,   ///< no pattern: no wave, or nothing for its strokes to follow
  ground,  ///< between strokes
  stroke
};

/// The twin of strokes.glsl with the stripes of stripe_middle.glsl: stripes end where they do, they
/// are not filtered. `tone` is how light the surface is there, 0 to 1.
Cover cover_at(const SeenPoint& point, float tone);

/// Whether any strokes of the surface follow the light.
bool follows_tone(const StyledSurface& surface);

/// Whether tiles have their borders where pixels are: their value is looked for in their middle.
bool follows_values(const RegionTexture& texture);

/// Which of the texture's tiles has its figure at a point of a surface that has one; nothing: none
/// has. The twin of region_texture.glsl for tiles with figures, which are not filtered. Pictures
/// have no figure.
std::optional<std::size_t> tile_at(const SeenPoint& point);

}  // namespace brindle
