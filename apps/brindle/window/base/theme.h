/// The look of the window's text and widgets.
#pragma once

#include <imgui.h>

namespace brindle::tool {

/// Loads a proportional system font, or Dear ImGui's own if there is none. `scale` enlarges text;
/// glyphs are rasterized for `pixels_per_unit`.
void load_fonts(float scale, float pixels_per_unit);

/// The colour of errors and warnings.
ImVec4 warning_color(bool dark);

/// Sets light or dark colours, and distances.
void apply_theme(bool dark, float scale);

}  // namespace brindle::tool
