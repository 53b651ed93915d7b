/// Parsers for pictures on command lines and in scripts.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "brindle/camera.h"
#include "brindle/color_map.h"
#include "brindle/glyphs.h"
#include "brindle/image.h"
#include "brindle/renderer.h"

namespace brindle {

/// Parses "azimuth,elevation" or "azimuth,elevation,zoom", in degrees, with the given `up`. Empty
/// for other text, numbers that are not finite, an elevation outside -90 .. 90 or a zoom outside
/// 0.01 .. 10000.
std::optional<CameraView> parse_camera_view(std::string_view text, UpAxis up = UpAxis::y);

/// Reads "x", "y", "z", "-x", "-y" and "-z". Empty if the text is none of these.
std::optional<UpAxis> parse_up_axis(std::string_view text);
std::string_view name_of(UpAxis up);

/// The axis that points up in built-in shapes ("shape:torus") and in most files of this extension:
/// z in shapes and .stl. Empty if the extension does not tell; pictures then have y up.
std::optional<UpAxis> usual_up_axis(const std::string& mesh);

/// What `parse_camera_view` reads, for messages.
inline constexpr const char* kCameraViewForm =
    "AZIMUTH,ELEVATION or AZIMUTH,ELEVATION,ZOOM, elevation from -90 to 90, zoom from 0.01 to "
    "10000";

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
