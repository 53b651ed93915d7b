#include "window/dialogs/shape_dialog.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <utility>

#include <imgui.h>

#include "brindle/base/text.h"
#include "cli/option_values.h"
#include "window/base/value_slider.h"

namespace brindle::tool {
namespace {

constexpr std::string_view kPrefix = "shape:";

std::string standard_of(const ShapeParameter& parameter) {
  return formatted("%g", parameter.standard);
}

// A slider over the full range, such as 0.001 to 1000, would be useless.
SliderRange useful_range(const ShapeParameter& parameter) {
  const double standard = parameter.standard;
  double most = std::max(4 * std::abs(standard), parameter.whole ? 20.0 : 2.0);
  if (parameter.upper - parameter.lower < 10) most = parameter.upper;
  return {.lowest = std::max(parameter.lower, standard > 0 ? standard / 20 : 0),
          .highest = std::min(parameter.upper, most)};
}

}  // namespace

std::string shape_text(const ShapeInfo& shape, const std::map<std::string, std::string>& values) {
  std::string text = std::string(kPrefix) + shape.name;
  for (const ShapeParameter& parameter : shape.parameters) {
    const auto found = values.find(parameter.name);
    if (found == values.end() || found->second == standard_of(parameter)) continue;
    text += "," + parameter.name + "=" + found->second;
  }
  return text;
}

std::map<std::string, std::string> shape_values(const std::string& text) {
  std::map<std::string, std::string> values;
  for (const std::string& part : split(text, ',')) {
    const std::size_t equals = part.find('=');
    if (equals != part.npos) values[part.substr(0, equals)] = part.substr(equals + 1);
  }
  return values;
}

ShapeDialog::ShapeDialog(LiveSession& live, WindowLog& log,
                         std::function<void(const std::string&)> open)
    : live_(live), log_(log), open_(std::move(open)), shapes_(shape_catalogue()) {}

void ShapeDialog::draw() {
  if (!is_open_) return;
  ImGui::SetNextWindowSize({24 * ImGui::GetFontSize(), 0}, ImGuiCond_Appearing);
  ImGui::SetNextWindowPos(ImGui::GetMainViewport()->GetCenter(), ImGuiCond_Appearing, {0.5f, 0.5f});
  if (ImGui::Begin("Shape", &is_open_, ImGuiWindowFlags_NoCollapse)) {
    const std::string mesh = live_.document().mesh;
    const std::string name =
        mesh.starts_with(kPrefix) ? split(mesh.substr(kPrefix.size()), ',').front() : "";
    ImGui::SetNextItemWidth(-1);
    if (ImGui::BeginCombo("##shape", name.empty() ? "choose a shape" : name.c_str())) {
      for (const ShapeInfo& shape : shapes_) {
        if (ImGui::Selectable((shape.name + ": " + shape.help).c_str(), shape.name == name)) {
          open_(shape_text(shape, {}));
        }
      }
      ImGui::EndCombo();
    }
    const auto shape = std::ranges::find(shapes_, name, &ShapeInfo::name);
    if (shape != shapes_.end()) {
      for (const ShapeParameter& parameter : shape->parameters) draw_parameter(*shape, parameter);
    }
  }
  ImGui::End();
}

void ShapeDialog::draw_parameter(const ShapeInfo& shape, const ShapeParameter& parameter) {
  auto values = shape_values(live_.document().mesh);
  const auto found = values.find(parameter.name);
  const std::string text = found == values.end() ? standard_of(parameter) : found->second;
  const SliderRange range = useful_range(parameter);
  float value = std::strtof(text.c_str(), nullptr);
  ImGui::SetNextItemWidth(0.55f * ImGui::GetWindowWidth());
  const ValueChange change =
      value_slider(parameter.name.c_str(), value, static_cast<float>(range.lowest),
                   static_cast<float>(range.highest), parameter.whole ? "%.0f" : "%.4g");
  log_.note_widget("shape " + parameter.name);
  if (ImGui::IsItemHovered()) {
    ImGui::SetTooltip("%s, from %.10g to %.10g", parameter.help.c_str(), parameter.lower,
                      parameter.upper);
  }
  const std::string after = text_of_value(value, change, parameter.whole);
  if (change == ValueChange::none || after == text) return;
  values[parameter.name] = after;
  live_.apply_value(change, commands::open(shape_text(shape, values), true));
}

}  // namespace brindle::tool
