/// Colour maps for values.
#pragma once

#include <optional>
#include <string_view>

#include "brindle/export.h"
#include "brindle/image.h"

namespace BRINDLE_EXPORT brindle {

/// Maps in which equal steps look about equal, also to colour-blind eyes. The first three grow
/// lighter from the lowest value to the highest (van der Walt and Smith 2015; Nuñez et al. 2018);
/// coolwarm is lightest in the middle (Moreland 2009).
enum class ColorMap { viridis, magma, cividis, coolwarm };

/// Reads the names above. Empty if there is no such map.
std::optional<ColorMap> parse_color_map(std::string_view name);

/// The names above, separated by `|`.
std::string_view color_map_names();

/// The colour at `place`, 0 (lowest) to 1 (highest); beyond that, and for NaN, the nearest end's or
/// the lowest one's.
Color map_color(ColorMap map, float place);

}  // namespace brindle
