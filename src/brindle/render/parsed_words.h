/// Parsers for pictures on command lines and in scripts.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>

#include "brindle/camera.h"
#include "brindle/glyphs.h"
#include "brindle/image.h"
#include "brindle/renderer.h"

namespace brindle {

/// Reads "azimuth,elevation", in degrees, or the name of a side such as "front", either with
/// ",zoom", into a view with `up`. Empty if the text is not that, a number is not finite, elevation
/// is beyond -90 .. 90 or zoom is not in 0.01 .. 10000.
std::optional<CameraView> parse_camera_view(std::string_view text, UpAxis up = UpAxis::y);

/// Reads "x", "y", "z", "-x", "-y" and "-z". Empty if the text is none of these.
std::optional<UpAxis> parse_up_axis(std::string_view text);
std::string_view name_of(UpAxis up);

/// The axis that points up in built-in shapes ("shape:torus") and in most files of this extension:
/// z in shapes and .stl. Empty if the extension does not tell; pictures then have y up.
std::optional<UpAxis> usual_up_axis(const std::string& mesh);

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

/// Parses "azimuth,elevation" in degrees. Empty for other text, numbers that are not finite or an
/// elevation outside -90 .. 90.
std::optional<LightDirection> parse_light_direction(std::string_view text);

/// Parses "x=0.2", "z=50%" (of the bounding box), "-z=50%" (the other side), or a point and a
/// normal, "x,y,z,nx,ny,nz". Empty for other text, numbers that are not finite or a zero normal.
std::optional<Slice> parse_slice(std::string_view text);

/// Parses "#rrggbb" or "#rgb", with or without '#', and CSS names such as "steelblue". Empty for
/// other text.
std::optional<Color> parse_color(std::string_view text);

/// Parses the name of a map. Empty for other text.
std::optional<ColorMap> parse_color_map(std::string_view name);

/// Parses the name of a shape except `quad`, which needs a picture. Empty for other text.
std::optional<GlyphShape> parse_glyph_shape(std::string_view name);

/// Parses the name of a tile. Empty for other text.
std::optional<BuiltInTile> parse_built_in_tile(std::string_view name);

}  // namespace brindle
