#include "window/panels/other_surfaces.h"

#include <algorithm>
#include <array>
#include <cfloat>
#include <filesystem>
#include <optional>
#include <utility>

#include <imgui.h>
#include <imgui_stdlib.h>

#include "brindle/base/text.h"
#include "brindle/renderer.h"
#include "cli/described_options.h"
#include "cli/option_values.h"
#include "session/session_options.h"
#include "window/base/value_slider.h"

namespace brindle::tool {
namespace {

/// "2: ball.ply", without folders and style.
std::string title_of(const std::vector<std::string>& given, std::size_t index) {
  const std::string mesh = given[index].substr(0, given[index].find('@'));
  const bool shape = mesh.starts_with("shape:");
  return std::to_string(index + 1) + ": " +
         (shape ? mesh.substr(6) : std::filesystem::path(mesh).filename().string());
}

void label(const char* words, float column, const char* help) {
  ImGui::AlignTextToFramePadding();
  ImGui::Indent();
  ImGui::TextDisabled("%s", words);
  ImGui::Unindent();
  if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s", help);
  ImGui::SameLine(column);
  ImGui::SetNextItemWidth(-FLT_MIN);
}

/// A slider for a value that defaults to the first surface's.
ValueChange own_slider(const char* id, std::optional<float>& value, float usual, float lowest,
                       float highest) {
  float shown = value.value_or(usual);
  const std::string format = value ? "%.4g" : "as the first";
  const ValueChange change = slider_beside_number(id, shown, lowest, highest, format.c_str());
  if (change != ValueChange::none) value = std::clamp(shown, lowest, highest);
  return change;
}

/// The kind of a surface's look.
struct Looks {
  const char* words;
  bool striped = false, tiled = false;
  BetweenStrokes between = BetweenStrokes::surface;

  bool are_of(const OtherSurfaceChoice& choice) const {
    return striped == choice.striped && tiled == !choice.tile.empty() && between == choice.between;
  }
};

constexpr std::array kLooks = {
    Looks{.words = "plain"}, Looks{.words = "striped", .striped = true},
    Looks{.words = "stripes alone", .striped = true, .between = BetweenStrokes::discarded},
    Looks{.words = "tiles", .tiled = true},
    Looks{.words = "tiles alone", .tiled = true, .between = BetweenStrokes::discarded}};

constexpr const char* kUsualTile = "dots";

}  // namespace

void OtherSurfaces::draw_list(const std::vector<std::string>& given, const Set& set) {
  chosen_ = std::min(chosen_, given.empty() ? 0 : given.size() - 1);
  ImGui::SetNextItemWidth(-FLT_MIN);
  const std::string current = given.empty() ? "none" : title_of(given, chosen_);
  const bool open = ImGui::BeginCombo("##surfaces", current.c_str());
  log_.note_widget("other surfaces");
  if (!open) return;
  for (std::size_t i = 0; i < given.size(); ++i) {
    if (ImGui::Selectable(title_of(given, i).c_str(), i == chosen_)) chosen_ = i;
    log_.note_widget("other surface " + std::to_string(i + 1));
  }
  const auto add = [this, given, set](const std::string& mesh) {
    std::vector<std::string> more = given;
    more.push_back(mesh);
    chosen_ = given.size();
    set(std::move(more), ValueChange::typed);
  };
  if (ImGui::Selectable("add a file...")) {
    browser_.ask({.title = "Another surface of the picture",
                  .extensions = words_between_spaces(kMeshFiles),
                  .done = [add](const std::filesystem::path& path) { add(path.string()); }});
  }
  log_.note_widget("add surface file");
  if (ImGui::Selectable("add a sphere")) add("shape:sphere");
  log_.note_widget("add surface shape");
  ImGui::EndCombo();
}

void OtherSurfaces::draw_style(const std::vector<std::string>& given, const Set& set, float column,
                               double diagonal) {
  is_held_ = false;
  if (given.empty()) return;
  chosen_ = std::min(chosen_, given.size() - 1);
  const auto changed = [&](const OtherSurfaceChoice& choice, ValueChange change) {
    std::vector<std::string> values = given;
    values[chosen_] = text_of(choice);
    if (values != given) set(std::move(values), change);
  };
  ImGui::PushID(static_cast<int>(chosen_));
  draw_choice(parse_other_surface("--with", given[chosen_]), changed, column, diagonal);
  label("", column, "");
  if (ImGui::Button("leave it out", {-FLT_MIN, 0})) {
    std::vector<std::string> values = given;
    values.erase(values.begin() + static_cast<std::ptrdiff_t>(chosen_));
    set(std::move(values), ValueChange::typed);
  }
  log_.note_widget("remove surface");
  ImGui::PopID();
}

void OtherSurfaces::draw_choice(OtherSurfaceChoice choice, const Changed& changed, float column,
                                double diagonal) {
  label("looks", column,
        "plain, with stripes or the tiles of a texture on it, or left out between these");
  draw_kind(choice, changed);
  if (!choice.tile.empty()) {
    label("tile", column, "of its texture");
    draw_tile(choice, changed);
  }
  label("colours", column, "of the surface, and of its stripes or motifs");
  draw_colors(choice, changed);
  label("colours by", column,
        "a value of this surface, such as array:NAME of its file: its stripes have the colours, or "
        "the surface if it has none");
  draw_value(choice, changed);
  if (choice.has_pattern()) draw_stripes(choice, changed, column);
  label("moved by", column, "x, y and z, in the units of the first surface");
  draw_place(choice, changed, diagonal);
  draw_boxes(choice, changed);
}

void OtherSurfaces::draw_kind(OtherSurfaceChoice& choice, const Changed& changed) {
  const auto current =
      std::ranges::find_if(kLooks, [&](const Looks& looks) { return looks.are_of(choice); });
  const bool open = ImGui::BeginCombo("##kind", current == kLooks.end() ? "" : current->words);
  log_.note_widget("surface looks");
  if (!open) return;
  for (const Looks& looks : kLooks) {
    if (ImGui::Selectable(looks.words, looks.are_of(choice))) {
      const std::string usual = choice.tile.empty() ? kUsualTile : choice.tile;
      choice =
          with_pattern(std::move(choice), looks.striped, looks.tiled ? usual : "", looks.between);
      changed(choice, ValueChange::typed);
    }
    log_.note_widget(std::string("surface looks ") + looks.words);
  }
  ImGui::EndCombo();
}

void OtherSurfaces::draw_tile(OtherSurfaceChoice& choice, const Changed& changed) {
  const bool open = ImGui::BeginCombo("##tile", choice.tile.c_str(), ImGuiComboFlags_HeightLarge);
  log_.note_widget("surface tile");
  if (!open) return;
  for (const std::string& name : split(std::string(built_in_tile_names()), '|')) {
    if (ImGui::Selectable(name.c_str(), name == choice.tile)) {
      choice.tile = name;
      changed(choice, ValueChange::typed);
    }
    log_.note_widget("surface tile " + name);
  }
  ImGui::EndCombo();
}

// A text field and a list of names. Typed text is applied when complete.
void OtherSurfaces::draw_value(OtherSurfaceChoice& choice, const Changed& changed) {
  ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x - ImGui::GetFrameHeight());
  std::string text = edit_.value_or(choice.color_by);
  const bool entered =
      ImGui::InputTextWithHint("##value", "none", &text, ImGuiInputTextFlags_EnterReturnsTrue);
  log_.note_widget("surface value");
  if (ImGui::IsItemActive()) edit_ = text;
  if ((entered || ImGui::IsItemDeactivatedAfterEdit()) && text != choice.color_by) {
    changed(with_color_by(choice, text), ValueChange::typed);
  }
  if (ImGui::IsItemDeactivated()) edit_.reset();
  draw_value_names(choice, changed);
}

void OtherSurfaces::draw_value_names(const OtherSurfaceChoice& choice, const Changed& changed) {
  ImGui::SameLine(0, 0);
  if (ImGui::ArrowButton("values", ImGuiDir_Down)) ImGui::OpenPopup("values");
  log_.note_widget("surface values");
  if (!ImGui::BeginPopup("values")) return;
  std::vector<std::string> names = {"curvature", "height"};
  if (live_.frame() && live_.frame()->state->others &&
      chosen_ < live_.frame()->state->others->size()) {
    for (const DataArray& array : (*live_.frame()->state->others)[chosen_].arrays.points) {
      names.push_back("array:" + array.name);
    }
  }
  for (const std::string& name : names) {
    if (ImGui::Selectable(name.c_str(), name == choice.color_by)) {
      changed(with_color_by(choice, name), ValueChange::typed);
    }
    log_.note_widget("surface values " + name);
  }
  if (!choice.color_by.empty() && ImGui::Selectable("none")) {
    changed(with_color_by(choice, ""), ValueChange::typed);
  }
  ImGui::EndPopup();
}

void OtherSurfaces::draw_colors(OtherSurfaceChoice& choice, const Changed& changed) {
  const bool by_value = choice.colors_pattern();
  // Surfaces coloured by values have no other colour.
  const bool has_own = !by_value || choice.between == BetweenStrokes::surface;
  if (has_own) {
    Color surface = choice.color.value_or(kOtherColor);
    if (color_swatch("surface", surface, is_held_)) {
      choice.color = surface;
      changed(choice, ValueChange::dragged);
    }
    log_.note_widget("surface color");
  } else {
    ImGui::TextDisabled("by the value");
  }
  if (choice.has_pattern() && !by_value) {
    ImGui::SameLine();
    Color stripes = choice.stripe_color.value_or(RenderOptions().stripe_color);
    if (live_.frame()) {
      const auto& first = live_.frame()->state->parsed->arguments().picture;
      stripes = choice.stripe_color.value_or(first.render.stripe_color);
    }
    if (color_swatch("stripes", stripes, is_held_)) {
      choice.stripe_color = stripes;
      changed(choice, ValueChange::dragged);
    }
    log_.note_widget("surface stripe color");
  }
}

void OtherSurfaces::draw_stripes(OtherSurfaceChoice& choice, const Changed& changed, float column) {
  const auto row = [&](const char* words, const char* help, std::optional<float>& value,
                       float usual, float lowest, float highest) {
    label(words, column, help);
    const std::string id = std::string("##") + words;
    const ValueChange change = own_slider(id.c_str(), value, usual, lowest, highest);
    log_.note_widget(std::string("surface ") + words);
    if (change != ValueChange::none) changed(choice, change);
  };
  row("stripes", "along the diagonal of this surface; else as dense as the first's", choice.stripes,
      40, 2, 200);
  if (choice.striped) row("width", "as a share of the period", choice.stripe_width, 0.5f, 0, 1);
  row("rotate", "of the field about the normals, in degrees", choice.rotate_deg, 0, -180, 180);
}

void OtherSurfaces::draw_place(OtherSurfaceChoice& choice, const Changed& changed,
                               double diagonal) {
  static constexpr std::array kAxes = {"##x", "##y", "##z"};
  const float gap = ImGui::GetStyle().ItemInnerSpacing.x;
  const float width = (ImGui::GetContentRegionAvail().x - 2 * gap) / 3;
  const auto speed = static_cast<float>(std::max(0.002 * diagonal, 1e-6));
  for (int axis = 0; axis < 3; ++axis) {
    if (axis > 0) ImGui::SameLine(0, gap);
    ImGui::SetNextItemWidth(width);
    auto value = static_cast<float>(choice.moved[axis]);
    const ValueChange change =
        value_drag(kAxes[static_cast<std::size_t>(axis)], value, speed, "%.3g");
    log_.note_widget(std::string("surface place ") + static_cast<char>('x' + axis));
    if (change == ValueChange::none) continue;
    choice.moved[axis] = static_cast<double>(value);
    changed(choice, change);
  }
}

// Options that need others are shown with these.
void OtherSurfaces::draw_boxes(OtherSurfaceChoice& choice, const Changed& changed) {
  const OptionValues given = shown_options(live_.document());
  const auto box = [&](const char* words, bool shown, bool on, auto&& turn) {
    if (!shown && !on) return;
    ImGui::Indent();
    if (ImGui::Checkbox(words, &on)) {
      turn(on);
      changed(choice, ValueChange::typed);
    }
    ImGui::Unindent();
    log_.note_widget(std::string("surface ") + words);
  };
  box("outlined", !given.contains("outline"), choice.outlined,
      [&](bool on) { choice.outlined = on; });
  box("not cut open", given.contains("slice"), choice.whole, [&](bool on) { choice.whole = on; });
  box("no depth tint", given.contains("depth-cue"), !choice.tinted,
      [&](bool on) { choice.tinted = !on; });
}

}  // namespace brindle::tool
