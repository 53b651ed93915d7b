#include "window/base/value_slider.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include <imgui_internal.h>

#include "brindle/base/text.h"

namespace brindle::tool {
namespace {

// `draw` shows a widget for a number and returns whether it changed. During text input, the edited
// value is stored beside the actual one.
template <class Draw>
ValueChange typed_as_a_whole(const char* label, float& value, const Draw& draw) {
  ImGuiStorage& storage = *ImGui::GetStateStorage();
  const ImGuiID is_typed = ImGui::GetID((std::string(label) + " is typed").c_str());
  const ImGuiID typed = ImGui::GetID((std::string(label) + " typed").c_str());
  const bool was_typed = storage.GetBool(is_typed);
  float drawn = was_typed ? storage.GetFloat(typed) : value;
  const bool changed = draw(drawn);
  const bool still_typed = ImGui::TempInputIsActive(ImGui::GetID(label));
  storage.SetBool(is_typed, still_typed);
  if (still_typed) {
    storage.SetFloat(typed, drawn);
    return ValueChange::none;
  }
  if (!was_typed) {
    value = drawn;
    return changed ? ValueChange::dragged : ValueChange::none;
  }
  const bool left_alone = ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape));
  if (left_alone || drawn == value) return ValueChange::none;
  value = drawn;
  return ValueChange::typed;
}

}  // namespace

ValueChange value_slider(const char* label, float& value, float lowest, float highest,
                         const char* format, ImGuiSliderFlags flags) {
  return typed_as_a_whole(label, value, [&](float& drawn) {
    return ImGui::SliderFloat(label, &drawn, lowest, highest, format, flags);
  });
}

ValueChange slider_beside_number(const char* label, float& value, float lowest, float highest,
                                 const char* format, ImGuiSliderFlags flags) {
  // Text fields show the typed text.
  if (ImGui::TempInputIsActive(ImGui::GetID(label))) {
    return value_slider(label, value, lowest, highest, format, flags);
  }
  const auto number = [&] { return formatted(format, static_cast<double>(value)); };
  const ImU32 color = ImGui::GetColorU32(ImGuiCol_Text);
  const float gap = ImGui::GetStyle().ItemInnerSpacing.x;
  const float room =
      std::max(ImGui::CalcTextSize("0.0000").x, ImGui::CalcTextSize(number().c_str()).x) + gap;
  ImGui::SetNextItemWidth(std::max(2 * ImGui::GetFontSize(), ImGui::CalcItemWidth() - room));
  // The slider's own number would be under the knob.
  ImGui::PushStyleColor(ImGuiCol_Text, ImVec4(0, 0, 0, 0));
  const ValueChange change = value_slider(label, value, lowest, highest, format, flags);
  ImGui::PopStyleColor();
  const std::string text = number();
  const ImVec2 at(ImGui::GetItemRectMax().x + room - ImGui::CalcTextSize(text.c_str()).x,
                  ImGui::GetItemRectMin().y + ImGui::GetStyle().FramePadding.y);
  ImGui::GetWindowDrawList()->AddText(at, color, text.c_str());
  return change;
}

ValueChange value_drag(const char* label, float& value, float speed, const char* format) {
  return typed_as_a_whole(label, value, [&](float& drawn) {
    return ImGui::DragFloat(label, &drawn, speed, 0, 0, format);
  });
}

std::string text_of_value(float value, ValueChange change, bool whole) {
  if (change == ValueChange::typed) {
    std::array<char, 64> text{};
    const auto end = std::to_chars(text.data(), text.data() + text.size(), value);
    return {text.data(), end.ptr};
  }
  return whole ? std::to_string(std::lround(value)) : formatted("%.4g", static_cast<double>(value));
}

bool color_swatch(const char* name, Color& color, bool& held) {
  std::array<float, 3> channels = {color.red, color.green, color.blue};
  const bool changed = ImGui::ColorEdit3(
      name, channels.data(), ImGuiColorEditFlags_NoInputs | ImGuiColorEditFlags_NoLabel);
  if (changed) color = {channels[0], channels[1], channels[2]};
  held |= ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopupId) && ImGui::GetIO().WantTextInput;
  return changed;
}

}  // namespace brindle::tool
