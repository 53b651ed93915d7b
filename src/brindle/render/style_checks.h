/// Checks of styled surfaces, for pictures and drawings.
#pragma once

#include <cstddef>

#include "brindle/styled_picture.h"

namespace brindle {

inline constexpr std::size_t kMostStrokes = 2;  ///< patterns on a surface

/// Throws Error for data that do not fit the surface or are out of range.
void check_style(const StyledSurface& surface);

}  // namespace brindle
