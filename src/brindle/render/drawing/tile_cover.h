/// Whether figures of a texture's tiles cover a point.
#pragma once

#include <cstddef>
#include <optional>

#include "brindle/render/drawing/stroke_cover.h"

namespace brindle {

/// Whether tiles have their borders where pixels are: their value is looked for in their middle.
bool follows_values(const RegionTexture& texture);

/// Which of the texture's tiles has its figure at a point of a surface that has one; nothing: none
/// has. The twin of region_texture.glsl for tiles with figures, which are not filtered. Pictures
/// have no figure.
std::optional<std::size_t> tile_at(const SeenPoint& point);

}  // namespace brindle
