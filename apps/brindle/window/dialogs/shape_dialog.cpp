#include "window/dialogs/shape_dialog.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <sstream>
#include <utility>

#include <imgui.h>

#include "brindle/shapes.h"
#include "cli/option_values.h"
#include "window/base/value_slider.h"

namespace brindle::tool {
namespace {

constexpr std::string_view kPrefix = "shape:";

// Parses "major=0.7  radius of the ring (a number from 0.001 to 1000)".
ShapeParameter parameter_in(const std::string& line) {
  ShapeParameter parameter;
  const std::size_t equals = line.find('=');
  const std::size_t gap = line.find("  ", equals);
  parameter.name = line.substr(0, equals);
  parameter.standard = line.substr(equals + 1, gap - equals - 1);
  parameter.help = gap == line.npos ? "" : line.substr(gap + 2);
  parameter.whole = line.find("(a whole number") != line.npos;
  const std::size_t from = line.rfind(" from ");
  const std::size_t to = line.rfind(" to ");
  if (from != line.npos && to != line.npos) {
    parameter.lowest = std::strtof(line.c_str() + from + 6, nullptr);
    parameter.highest = std::strtof(line.c_str() + to + 4, nullptr);
  }
  return parameter;
}

// A slider over the full range, such as 0.001 to 1000, would be useless.
SliderRange useful_range(const ShapeParameter& parameter) {
  const float standard = std::strtof(parameter.standard.c_str(), nullptr);
  float most = std::max(4 * std::abs(standard), parameter.whole ? 20.0f : 2.0f);
  if (parameter.highest - parameter.lowest < 10) most = parameter.highest;
  return {.lowest = std::max(parameter.lowest, standard > 0 ? standard / 20 : 0),
          .highest = std::min(parameter.highest, most)};
}

}  // namespace

std::vector<ShapeEntry> shape_entries(const std::string& help) {
  std::vector<ShapeEntry> shapes;
  std::istringstream lines(help);
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with("    ") && !shapes.empty()) {
      shapes.back().parameters.push_back(parameter_in(line.substr(4)));
    } else if (const std::size_t colon = line.find(": "); colon != line.npos) {
      shapes.push_back({line.substr(0, colon), line.substr(colon + 2), {}});
    }
  }
  return shapes;
}

std::string shape_text(const ShapeEntry& shape, const std::map<std::string, std::string>& values) {
  std::string text = std::string(kPrefix) + shape.name;
  for (const ShapeParameter& parameter : shape.parameters) {
    const auto found = values.find(parameter.name);
    if (found == values.end() || found->second == parameter.standard) continue;
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
    : live_(live), log_(log), open_(std::move(open)), shapes_(shape_entries(shape_help())) {}

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
      for (const ShapeEntry& shape : shapes_) {
        if (ImGui::Selectable((shape.name + ": " + shape.help).c_str(), shape.name == name)) {
          open_(shape_text(shape, {}));
        }
      }
      ImGui::EndCombo();
    }
    const auto shape = std::ranges::find(shapes_, name, &ShapeEntry::name);
    if (shape != shapes_.end()) {
      for (const ShapeParameter& parameter : shape->parameters) draw_parameter(*shape, parameter);
    }
  }
  ImGui::End();
}

void ShapeDialog::draw_parameter(const ShapeEntry& shape, const ShapeParameter& parameter) {
  auto values = shape_values(live_.document().mesh);
  const auto found = values.find(parameter.name);
  const std::string text = found == values.end() ? parameter.standard : found->second;
  const SliderRange range = useful_range(parameter);
  float value = std::strtof(text.c_str(), nullptr);
  ImGui::SetNextItemWidth(0.55f * ImGui::GetWindowWidth());
  const ValueChange change =
      value_slider(parameter.name.c_str(), value, static_cast<float>(range.lowest),
                   static_cast<float>(range.highest), parameter.whole ? "%.0f" : "%.4g");
  log_.note_widget("shape " + parameter.name);
  if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s", parameter.help.c_str());
  const std::string after = text_of_value(value, change, parameter.whole);
  if (change == ValueChange::none || after == text) return;
  values[parameter.name] = after;
  live_.apply_value(change,
                    commands::Open{.mesh = shape_text(shape, values), .keep_strokes = true});
}

}  // namespace brindle::tool
