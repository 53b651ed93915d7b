/// Words of pictures, as command lines and scripts have them.
#pragma once

#include <array>
#include <optional>
#include <string_view>

#include "brindle/camera.h"
#include "brindle/color_map.h"
#include "brindle/glyphs.h"
#include "brindle/image.h"
#include "brindle/renderer.h"

namespace brindle {

/// Reads "azimuth,elevation", in degrees, or the name of a side such as "front", either with
/// ",zoom", into a view with `up`. Empty if the text is not that, a number is not finite, elevation
/// is beyond -90 .. 90 or zoom is not in 0.01 .. 10000.
std::optional<CameraView> parse_camera_view(std::string_view text, UpAxis up = UpAxis::y);

/// What `parse_camera_view` reads, for messages.
inline constexpr const char* kCameraViewForm =
    "AZIMUTH,ELEVATION[,ZOOM], elevation from -90 to 90, zoom from 0.01 to 10000, or front, back, "
    "left, right, top or bottom[,ZOOM]";

/// A side that a view may be from.
struct ViewSide {
  std::string_view name;
  float azimuth_deg, elevation_deg;
};
inline constexpr std::array<ViewSide, 6> kViewSides = {{{"front", 0, 0},
                                                        {"back", 180, 0},
                                                        {"left", -90, 0},
                                                        {"right", 90, 0},
                                                        {"top", 0, 90},
                                                        {"bottom", 0, -90}}};

/// Reads "azimuth,elevation" in degrees. Empty if the text is not that, a number is not finite, or
/// elevation is beyond -90 .. 90.
std::optional<LightDirection> parse_light_direction(std::string_view text);

/// Reads "x=0.2", "z=50%" (of the bounding box), "-z=50%", which takes away the other side, or a
/// point and a normal: "x,y,z,nx,ny,nz". Empty if the text is none of these, a number is not finite
/// or the normal is zero.
std::optional<Slice> parse_slice(std::string_view text);

/// Reads "#rrggbb" or "#rgb", with or without the '#', and names of CSS such as "steelblue". Empty
/// if the text is none of these.
std::optional<Color> parse_color(std::string_view text);

/// Reads the names of the maps. Empty if there is no such map.
std::optional<ColorMap> parse_color_map(std::string_view name);

/// Reads the names of the shapes but `quad`, which needs a picture. Empty if there is no such
/// shape.
std::optional<GlyphShape> parse_glyph_shape(std::string_view name);

/// Reads the names of the tiles. Empty if there is no such tile.
std::optional<BuiltInTile> parse_built_in_tile(std::string_view name);

}  // namespace brindle
