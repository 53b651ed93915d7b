/// Colour maps for values.
#pragma once

#include "brindle/export.h"
#include "brindle/image.h"

namespace BRINDLE_EXPORT brindle {

/// Perceptually uniform maps, also for colour-blind readers. The first three grow lighter from the
/// lowest value to the highest (van der Walt and Smith 2015; Nuñez et al. 2018); coolwarm is
/// lightest in the middle (Moreland 2009).
enum class ColorMap { viridis, magma, cividis, coolwarm };

/// The colour at `place`, 0 (lowest) to 1 (highest). Other places are clamped; NaN gives the lowest
/// colour.
Color map_color(ColorMap map, float place);

}  // namespace brindle
