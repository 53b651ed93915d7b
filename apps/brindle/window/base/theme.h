/// How the window's text and widgets look.
#pragma once

#include <imgui.h>

namespace brindle::tool {

/// Loads a proportional font of the system, Dear ImGui's own where there is none. `scale` enlarges
/// text; glyphs are drawn for `pixels_per_unit`.
void load_fonts(float scale, float pixels_per_unit);

/// Of what is wrong and what is probably not meant.
ImVec4 warning_color(bool dark);

/// Colours, light or dark, and distances.
void apply_theme(bool dark, float scale);

}  // namespace brindle::tool
