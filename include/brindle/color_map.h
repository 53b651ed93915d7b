/// Colour maps for values.
#pragma once

#include <string_view>

#include "brindle/export.h"
#include "brindle/image.h"

namespace BRINDLE_EXPORT brindle {

/// Maps in which equal steps look about equal, also to colour-blind eyes. The first three grow
/// lighter from the lowest value to the highest (van der Walt and Smith 2015; Nuñez et al. 2018);
/// coolwarm is lightest in the middle (Moreland 2009).
enum class ColorMap { viridis, magma, cividis, coolwarm };

/// The colour at `place`, 0 (lowest) to 1 (highest); beyond that, and for NaN, the nearest end's or
/// the lowest one's.
Color map_color(ColorMap map, float place);

}  // namespace brindle
