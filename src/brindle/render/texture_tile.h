/// Tiles: what a texture repeats, once for every period of U and V.
#pragma once

#include <optional>
#include <string_view>
#include <variant>

#include "brindle/render/color.h"
#include "brindle/render/image.h"

namespace brindle {

/// Tiles that need no file: a figure in one colour on the ground of another. All but arrows look
/// the same turned by 180 degrees about their middle, so they suit fields without orientation;
/// checker, dots and plus also turned by 90 degrees, so they suit cross fields.
enum class BuiltInTile {
  stripes,    ///< across U, as `Renderer` draws stripes of width 0.5
  checker,    ///< two by two squares, one in the middle
  dots,       ///< one in the middle
  arrows,     ///< one that points along U
  bricks,     ///< two courses along U, the second shifted by half a brick
  hatch,      ///< strokes along U that others cross along V
  plus,       ///< a plus sign
  minus,      ///< a minus sign along U
  plus_minus  ///< a plus sign in the middle and a minus sign at the corner
};

/// Reads the names above. Empty if there is no such tile.
std::optional<BuiltInTile> built_in_tile(std::string_view name);

/// The names above, separated by `|`.
std::string_view built_in_tile_names();

/// The distance from texture coordinates to the figure's border, in sides of the tile, negative
/// inside; coordinates repeat after 1.
float tile_distance(BuiltInTile tile, float u, float v);

/// A built-in tile, or a picture whose transparent parts show the surface.
using TextureTile = std::variant<BuiltInTile, Image>;

/// The tile as a picture without transparent parts: a figure in `side` x `side` pixels, edges
/// smoothed; a picture over `ground`. U runs to the right, V up.
/// Throws Error for sides that `check_image_size` refuses.
Image tile_picture(const TextureTile& tile, int side, const Color& figure, const Color& ground);

/// The pixel's light multiplied with its alpha: red, green, blue and alpha.
Eigen::Vector4f premultiplied_light(const Pixel& pixel);

/// The picture itself if no side is longer than `longest`, else halved until none is: pixels become
/// means of their light.
Image reduced(Image image, int longest);

}  // namespace brindle
