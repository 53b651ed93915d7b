/// Sliders that apply typed values when complete, and colours.
#pragma once

#include <string>

#include <imgui.h>

#include "brindle/image.h"
#include "window/base/live_session.h"

namespace brindle::tool {

/// Unlike Dear ImGui's sliders, which apply each typed character, these apply text on Enter or loss
/// of focus, and discard it on Escape.
ValueChange value_slider(const char* label, float& value, float lowest, float highest,
                         const char* format, ImGuiSliderFlags flags = 0);

/// The same at the end of a line, with the number to the right of the slider, where no knob hides
/// it.
ValueChange slider_beside_number(const char* label, float& value, float lowest, float highest,
                                 const char* format, ImGuiSliderFlags flags = 0);

/// The same without bounds; `speed` is the change per unit of mouse motion.
ValueChange value_drag(const char* label, float& value, float speed, const char* format);

/// A number as option text: typed values with all digits, dragged ones with four, or rounded to
/// integers.
std::string text_of_value(float value, ValueChange change, bool whole);

/// A colour to edit. Returns whether it changed; sets `held` while it is edited.
bool color_swatch(const char* name, Color& color, bool& held);

}  // namespace brindle::tool
