/// Sliders whose typed values count when they are whole.
#pragma once

#include <string>

#include <imgui.h>

#include "window/base/live_session.h"

namespace brindle::tool {

/// As the sliders of Dear ImGui, which apply what is typed with every key: here it counts once
/// Enter is pressed or the field is left, and not at all after Escape.
ValueChange value_slider(const char* label, float& value, float lowest, float highest,
                         const char* format, ImGuiSliderFlags flags = 0);

/// The same at the end of a line, in whose rest the number stands to the right of the slider: no
/// knob hides it.
ValueChange slider_beside_number(const char* label, float& value, float lowest, float highest,
                                 const char* format, ImGuiSliderFlags flags = 0);

/// The same of a number without ends; `speed` is how much a unit of the mouse's way adds.
ValueChange value_drag(const char* label, float& value, float speed, const char* format);

/// A number as options take it: what was typed to its last digit, what was dragged to four, or
/// rounded to a whole one.
std::string text_of_value(float value, ValueChange change, bool whole);

}  // namespace brindle::tool
