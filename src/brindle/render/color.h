/// Colours as a user writes them and as light adds up.
#pragma once

#include <optional>
#include <string_view>

#include "brindle/types.h"

namespace brindle {

/// An sRGB colour, each channel from 0 to 1.
struct Color {
  float red = 0;
  float green = 0;
  float blue = 0;

  bool operator==(const Color&) const = default;
};

/// Reads "#rrggbb" or "#rgb", with or without the '#'. Empty if the text is neither.
std::optional<Color> parse_color(std::string_view text);

/// The colour's light, in which mixing and shading are done.
Vec3 linear_light(const Color& color);

/// A colour map for errors: from pale sand (0) through orange and red to dark violet (1). Lightness
/// falls evenly (Oklab, Ottosson 2020), so equal steps look equal, in grey and to colour-blind eyes
/// too. Values outside 0 .. 1 are clamped.
Color error_color(float value);

}  // namespace brindle
