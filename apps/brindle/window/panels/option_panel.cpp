#include "window/panels/option_panel.h"

#include <algorithm>
#include <array>
#include <cfloat>
#include <cmath>
#include <optional>
#include <utility>

#include <imgui.h>
#include <imgui_stdlib.h>

#include "brindle/base/text.h"
#include "brindle/image.h"
#include "brindle/render/parsed_words.h"
#include "cli/option_values.h"
#include "pictures/picture.h"
#include "window/base/value_slider.h"

namespace brindle::tool {
namespace {

constexpr float kLabelShare = 0.48f;

/// Two numbers as text: "0.1..0.9", "0.4..2.5,inverse" or "30,20".
struct TwoNumbers {
  std::string first = "", between = ",", second = "", rest = "";

  std::string text() const { return first + between + second + rest; }
};

/// Empty for other text.
std::optional<TwoNumbers> numbers_in(const std::string& text) {
  TwoNumbers numbers;
  if (text.find("..") != text.npos) numbers.between = "..";
  const std::size_t at = text.find(numbers.between);
  if (at == text.npos) return std::nullopt;
  const std::size_t end = at + numbers.between.size();
  const std::size_t comma = std::min(text.find(',', end), text.size());
  numbers.first = text.substr(0, at);
  numbers.second = text.substr(end, comma - end);
  numbers.rest = text.substr(comma);
  const bool are_numbers = number_in<float>(numbers.first) && number_in<float>(numbers.second);
  return are_numbers ? std::optional(numbers) : std::nullopt;
}

void show_tooltip(const std::string& title, const std::string& text) {
  if (!ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled)) return;
  ImGui::BeginTooltip();
  ImGui::PushTextWrapPos(26 * ImGui::GetFontSize());
  ImGui::TextUnformatted(title.c_str());
  ImGui::TextDisabled("%s", text.c_str());
  ImGui::PopTextWrapPos();
  ImGui::EndTooltip();
}

}  // namespace

OptionPanel::OptionPanel(LiveSession& live, FileBrowser& browser, WindowLog& log)
    : live_(live), browser_(browser), log_(log), others_(live, browser, log) {
  for (const Shown shown : kAllShown) {
    catalogs_[static_cast<std::size_t>(shown)] = option_catalog(shown);
  }
}

void OptionPanel::note_session() {
  note_surface();
  if (noted_revision_ == live_.session().revision()) return;
  noted_revision_ = live_.session().revision();
  given_ = shown_options(live_.document());
}

// Updates the data for sliders and lists of names.
void OptionPanel::note_surface() {
  if (!live_.frame() || live_.frame()->state == noted_) return;
  const bool another = !noted_ || noted_->job->surface != live_.frame()->state->job->surface;
  noted_ = live_.frame()->state;
  if (!another) return;
  diagonal_ = bounding_box(noted_->job->surface->mesh).diagonal();
  arrays_.clear();
  for (const DataArray& array : noted_->job->data.arrays.points) {
    arrays_.push_back("array:" + array.name);
  }
}

void OptionPanel::draw() {
  is_held_ = false;
  note_session();
  draw_shown();
  draw_search();
  // The change may have switched the shown picture.
  note_session();
  std::size_t shown = 0;
  for (const OptionGroup& group : catalog()) shown += draw_group(group);
  if (shown == 0) ImGui::TextDisabled("no option has these words");
}

void OptionPanel::draw_shown() {
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted("show");
  for (const Shown shown : kAllShown) {
    const std::string name(name_of(shown));
    ImGui::SameLine();
    if (ImGui::RadioButton(name.c_str(), live_.document().shown == shown)) {
      live_.apply(commands::show(shown));
    }
    log_.note_widget("show " + name);
  }
}

void OptionPanel::draw_search() {
  ImGui::SetNextItemWidth(-FLT_MIN);
  ImGui::InputTextWithHint("##search", "search options", &search_);
  log_.note_widget("search");
  if (ImGui::IsItemFocused() && ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape))) {
    search_.clear();
  }
}

void OptionPanel::draw_option(const std::string& name) {
  note_session();
  for (const OptionGroup& group : catalog()) {
    const auto option = std::ranges::find(group.options, name, &CatalogOption::name);
    if (option == group.options.end()) continue;
    ImGui::PushID(name.c_str());
    draw_option(*option);
    ImGui::PopID();
  }
}

std::size_t OptionPanel::draw_group(const OptionGroup& group) {
  const bool searching = search_.find_first_not_of(' ') != std::string::npos;
  const auto is_shown = [&](const CatalogOption& option) {
    return !searching || is_meant(option, search_);
  };
  const auto shown = static_cast<std::size_t>(std::ranges::count_if(group.options, is_shown));
  if (shown == 0) return 0;
  if (searching) {
    ImGui::TextDisabled("%s", group.title.c_str());
  } else {
    const bool first = &group == &catalog().front();
    const bool open =
        ImGui::CollapsingHeader(group.title.c_str(), first ? ImGuiTreeNodeFlags_DefaultOpen : 0);
    log_.note_widget("group " + group.title);
    if (!open) return shown;
  }
  for (const CatalogOption& option : group.options) {
    if (!is_shown(option)) continue;
    ImGui::PushID(option.name.c_str());
    draw_option(option);
    ImGui::PopID();
  }
  ImGui::Dummy({0, ImGui::GetFontSize() * 0.3f});
  return shown;
}

void OptionPanel::draw_option(const CatalogOption& option) {
  const bool given = given_.contains(option.name);
  const float width = ImGui::GetContentRegionAvail().x;
  draw_label(option, given);
  const float column = ImGui::GetStyle().WindowPadding.x + kLabelShare * width;
  ImGui::SameLine(column);
  if (option.name == "with") return draw_others(option, column);
  ImGui::BeginGroup();
  draw_widget(option);
  ImGui::EndGroup();
  log_.note_widget("option " + option.name);
  if (ImGui::IsItemHovered() && !ImGui::IsAnyItemActive()) {
    show_tooltip("--" + option.name + " " + option.form, option.help);
  }
}

std::vector<std::string> OptionPanel::values_of(const CatalogOption& option) const {
  const auto found = given_.find(option.name);
  return found == given_.end() ? std::vector<std::string>() : found->second;
}

// A list, and below it the style of the selected surface.
void OptionPanel::draw_others(const CatalogOption& option, float column) {
  const OtherSurfaces::Set change = [this, option](std::vector<std::string> values,
                                                   ValueChange by) {
    if (values.empty()) {
      live_.apply(commands::clear_option(option.name));
    } else {
      set(option, std::move(values), by);
    }
  };
  others_.draw_list(values_of(option), change);
  log_.note_widget("option " + option.name);
  note_session();
  others_.draw_style(values_of(option), change, column, diagonal_);
  is_held_ |= others_.is_held();
}

void OptionPanel::draw_label(const CatalogOption& option, bool given) {
  ImGui::AlignTextToFramePadding();
  if (given) {
    ImGui::PushStyleColor(ImGuiCol_Text, ImGui::GetStyleColorVec4(ImGuiCol_CheckMark));
  }
  ImGui::TextUnformatted(option.words.c_str());
  if (given) ImGui::PopStyleColor();
  log_.note_widget("label " + option.name);
  show_tooltip("--" + option.name + " " + option.form, option.help);
  draw_menu(option, given);
}

void OptionPanel::draw_menu(const CatalogOption& option, bool given) {
  if (ImGui::IsItemClicked(ImGuiMouseButton_Left) && given) ImGui::OpenPopup("menu");
  if (ImGui::IsItemClicked(ImGuiMouseButton_Right)) ImGui::OpenPopup("menu");
  if (!ImGui::BeginPopup("menu")) return;
  if (ImGui::MenuItem("Leave out (as if not given)", nullptr, false, given)) {
    live_.apply(commands::clear_option(option.name));
  }
  log_.note_widget("clear " + option.name);
  const bool slides = option.kind == OptionKind::whole || option.kind == OptionKind::number ||
                      option.kind == OptionKind::length;
  if (slides || option.name == "slice") {
    ImGui::TextDisabled("Type a value:");
    draw_text(option, 0, 12 * ImGui::GetFontSize());
  }
  ImGui::EndPopup();
}

void OptionPanel::draw_widget(const CatalogOption& option) {
  if (option.name == "colors") return draw_colors(option);
  if (option.name == "slice") return draw_slice(option);
  if (option.repeatable) return draw_texts(option);
  switch (option.kind) {
    case OptionKind::flag:
      return draw_flag(option);
    case OptionKind::choice:
      return draw_choice(option);
    case OptionKind::whole:
    case OptionKind::number:
      return draw_number(option, "");
    case OptionKind::numbers:
      return draw_numbers(option);
    case OptionKind::length:
      return draw_number(option, "%");
    case OptionKind::text:
      return draw_text(option, 0, -FLT_MIN);
  }
}

// The given value, or the default.
std::string OptionPanel::text_of(const CatalogOption& option) const {
  const auto& options = given_;
  const auto found = options.find(option.name);
  if (found != options.end() && !found->second.empty()) return found->second.front();
  if (option.name == "frequency" && diagonal_ > 0 && noted_) {
    // The frequency of --stripes.
    const auto stripes = options.find("stripes");
    const auto count = stripes == options.end() ? 40 : number_in<float>(stripes->second.front());
    if (count) return formatted("%.4g", static_cast<double>(*count) / diagonal_);
  }
  return option.standard;
}

SliderRange OptionPanel::range_of(const CatalogOption& option) const {
  SliderRange range = option.range;
  if (option.name.starts_with("frequency") && diagonal_ > 0) {
    range.lowest = 2 / diagonal_;
    range.highest = 400 / diagonal_;
  }
  const auto& options = given_;
  if (const auto colors = options.find("color-range");
      option.name == "threshold" && colors != options.end()) {
    if (const auto ends = numbers_in(colors->second.front())) {
      range = {.lowest = *number_in<float>(ends->first),
               .highest = *number_in<float>(ends->second)};
    }
  }
  return range;
}

void OptionPanel::set(const CatalogOption& option, std::vector<std::string> values,
                      ValueChange change_by) {
  std::vector<std::string> cleared;
  for (const std::string& other : option.excludes) {
    if (given_.contains(other)) cleared.push_back(other);
  }
  // All changes during one press of the mouse are one step, which the frame's owner ends.
  live_.apply_value(change_by, cleared.empty()
                                   ? commands::set_option(option.name, values)
                                   : commands::set_options({{option.name, values}}, cleared));
}

void OptionPanel::draw_flag(const CatalogOption& option) {
  bool on = given_.contains(option.name);
  if (!ImGui::Checkbox("##flag", &on)) return;
  if (on) {
    set(option, {});
  } else {
    live_.apply(commands::clear_option(option.name));
  }
}

void OptionPanel::draw_choice(const CatalogOption& option) {
  const std::string current = text_of(option);
  ImGui::SetNextItemWidth(-FLT_MIN);
  if (!ImGui::BeginCombo("##choice", current.c_str())) return;
  for (const std::string& name : option.names) {
    const std::string label = name == option.standard ? name + " (default)" : name;
    if (ImGui::Selectable((label + "##" + name).c_str(), name == current)) set(option, {name});
    log_.note_widget("choice " + option.name + " " + name);
  }
  ImGui::EndCombo();
}

// A number, or a percentage of the diagonal. A slider cannot show other values, such as array:NAME
// and lengths in the mesh's units.
void OptionPanel::draw_number(const CatalogOption& option, const std::string& suffix) {
  const std::string text = text_of(option);
  const auto known = text.ends_with(suffix)
                         ? number_in<float>(text.substr(0, text.size() - suffix.size()))
                         : std::nullopt;
  if (!known && !text.empty()) return draw_text(option, 0, -FLT_MIN);
  const SliderRange range = range_of(option);
  const bool dimmed = suffix.empty() ? !given_.contains(option.name) : !known;
  if (dimmed) {
    ImGui::PushStyleColor(ImGuiCol_Text, ImGui::GetStyleColorVec4(ImGuiCol_TextDisabled));
  }
  ImGui::SetNextItemWidth(-FLT_MIN);
  float value = known.value_or(static_cast<float>(range.lowest));
  // Dear ImGui needs a doubled per cent sign.
  const std::string shown = known ? text + suffix : "off";
  const ValueChange change = slider_beside_number(
      "##number", value, static_cast<float>(range.lowest), static_cast<float>(range.highest),
      shown.c_str(), range.logarithmic ? ImGuiSliderFlags_Logarithmic : 0);
  if (dimmed) ImGui::PopStyleColor();
  const std::string after = text_of_value(value, change, option.whole) + suffix;
  if (change != ValueChange::none && after != text) set(option, {after}, change);
}

// Two numbers, and an optional suffix.
void OptionPanel::draw_numbers(const CatalogOption& option) {
  const std::string text = text_of(option);
  std::optional<TwoNumbers> numbers = numbers_in(text);
  if (!numbers) return draw_text(option, 0, -FLT_MIN);
  std::array<float, 2> ends = {*number_in<float>(numbers->first),
                               *number_in<float>(numbers->second)};
  const bool given = given_.contains(option.name);
  if (!given) {
    ImGui::PushStyleColor(ImGuiCol_Text, ImGui::GetStyleColorVec4(ImGuiCol_TextDisabled));
  }
  const float gap = ImGui::GetStyle().ItemInnerSpacing.x;
  const float width = (ImGui::GetContentRegionAvail().x - gap) / 2;
  const float speed = std::max(0.002f * std::max(std::abs(ends[0]), std::abs(ends[1])), 1e-5f);
  ImGui::SetNextItemWidth(width);
  const ValueChange first = value_drag("##first", ends[0], speed, "%.4g");
  ImGui::SameLine(0, gap);
  ImGui::SetNextItemWidth(width);
  const ValueChange second = value_drag("##second", ends[1], speed, "%.4g");
  const ValueChange change = second == ValueChange::none ? first : second;
  if (!given) ImGui::PopStyleColor();
  // Unchanged parts keep their text.
  if (first != ValueChange::none) numbers->first = text_of_value(ends[0], first, false);
  if (second != ValueChange::none) numbers->second = text_of_value(ends[1], second, false);
  if (change != ValueChange::none && numbers->text() != text) {
    set(option, {numbers->text()}, change);
  }
}

// Value number `index` of an option: a text field, a list of names and a file browser.
void OptionPanel::draw_text(const CatalogOption& option, std::size_t index, float width) {
  const std::string id = option.name + " " + std::to_string(index);
  ImGui::PushID(id.c_str());
  const float button = ImGui::GetFrameHeight();
  const bool has_names = !option.names.empty() || option.form.find("array:") != std::string::npos;
  const float buttons = (has_names ? button : 0) + (option.files.empty() ? 0 : button);
  ImGui::SetNextItemWidth(width > 0 ? width : ImGui::GetContentRegionAvail().x - buttons);
  const std::vector<std::string> values = values_of(option);
  std::string text = index < values.size() ? values[index] : "";
  if (edited_ == id) text = edit_;
  const std::string hint = option.standard.empty() ? option.form : option.standard;
  const bool entered =
      ImGui::InputTextWithHint("##text", hint.c_str(), &text, ImGuiInputTextFlags_EnterReturnsTrue);
  log_.note_widget("text " + id);
  if (ImGui::IsItemActive()) {
    edited_ = id;
    edit_ = text;
  }
  if (entered || ImGui::IsItemDeactivatedAfterEdit()) set_one(option, index, text);
  if (ImGui::IsItemDeactivated() && edited_ == id) edited_.clear();
  if (has_names) draw_names(option, index);
  if (!option.files.empty()) {
    ImGui::SameLine(0, 0);
    if (ImGui::Button("...", {button, 0})) {
      browser_.ask({.title = option.words,
                    .extensions = option.files,
                    .done = [this, option, index](const std::filesystem::path& path) {
                      set_one(option, index, path.string());
                    }});
    }
    log_.note_widget("browse " + id);
  }
  ImGui::PopID();
}

// An empty value is removed.
void OptionPanel::set_one(const CatalogOption& option, std::size_t index,
                          const std::string& value) {
  const std::vector<std::string> before = values_of(option);
  std::vector<std::string> values = before;
  if (index < values.size()) {
    values[index] = value;
  } else {
    values.push_back(value);
  }
  std::erase(values, "");
  if (values == before) return;
  if (values.empty()) {
    live_.apply(commands::clear_option(option.name));
  } else {
    set(option, std::move(values));
  }
}

void OptionPanel::draw_names(const CatalogOption& option, std::size_t index) {
  ImGui::SameLine(0, 0);
  if (ImGui::ArrowButton("names", ImGuiDir_Down)) ImGui::OpenPopup("names");
  log_.note_widget("names " + option.name);
  if (!ImGui::BeginPopup("names")) return;
  for (const std::string& name : option.names) {
    if (ImGui::Selectable(name.c_str())) set_one(option, index, name);
    log_.note_widget("choice " + option.name + " " + name);
  }
  const bool takes_arrays = option.form.find("array:") != std::string::npos ||
                            option.form.find("VALUE") != std::string::npos;
  if (takes_arrays) {
    for (const std::string& name : arrays_) {
      if (ImGui::Selectable(name.c_str())) set_one(option, index, name);
    }
    if (arrays_.empty()) ImGui::TextDisabled("(the mesh has no arrays)");
  }
  ImGui::EndPopup();
}

void OptionPanel::draw_texts(const CatalogOption& option) {
  const std::size_t count = values_of(option).size();
  for (std::size_t index = 0; index <= count; ++index) draw_text(option, index, -FLT_MIN);
}

namespace {

/// Splits "x=50%" into axis and number; empty for other text.
std::optional<std::pair<std::string, float>> percent_slice(const std::string& text) {
  const std::vector<std::string> parts = split(text, '=');
  if (parts.size() != 2 || !parts[1].ends_with('%')) return std::nullopt;
  const auto percent = number_in<float>(parts[1].substr(0, parts[1].size() - 1));
  if (!percent) return std::nullopt;
  return std::pair(parts[0], *percent);
}

}  // namespace

// An axis and a position along it. Other planes are text.
void OptionPanel::draw_slice(const CatalogOption& option) {
  static constexpr std::array kAxes = {"x", "y", "z", "-x", "-y", "-z"};
  const std::string text = text_of(option);
  auto slice = percent_slice(text);
  if (!slice && !text.empty()) return draw_text(option, 0, -FLT_MIN);
  const float gap = ImGui::GetStyle().ItemInnerSpacing.x;
  ImGui::SetNextItemWidth(slice ? 0.3f * ImGui::GetContentRegionAvail().x : -FLT_MIN);
  const bool opened = ImGui::BeginCombo("##axis", slice ? slice->first.c_str() : "not");
  log_.note_widget("slice axis");
  if (opened) {
    if (ImGui::Selectable("not", !slice)) live_.apply(commands::clear_option(option.name));
    log_.note_widget("choice slice not");
    for (const char* axis : kAxes) {
      if (ImGui::Selectable(axis, slice && slice->first == axis)) {
        const std::string place = slice ? text.substr(text.find('=')) : "=50%";
        set(option, {axis + place});
      }
      log_.note_widget(std::string("choice slice ") + axis);
    }
    ImGui::EndCombo();
  }
  if (!slice) return;
  ImGui::SameLine(0, gap);
  ImGui::SetNextItemWidth(-FLT_MIN);
  // Dear ImGui needs a doubled per cent sign.
  const ValueChange change = slider_beside_number("##place", slice->second, 0, 100,
                                                  (text.substr(text.find('=') + 1) + "%").c_str());
  const std::string value = slice->first + "=" + text_of_value(slice->second, change, false) + "%";
  if (change != ValueChange::none && value != text) set(option, {value}, change);
}

// Swatches of the stripe, surface and background colours.
void OptionPanel::draw_colors(const CatalogOption& option) {
  static constexpr std::array kTitles = {"stripes", "surface", "background"};
  const RenderOptions standard;
  std::array<Color, 3> colors = {standard.stripe_color, standard.base_color,
                                 standard.background_edge};
  const auto found = given_.find(option.name);
  std::size_t given = 2;
  if (found != given_.end()) {
    const auto parts = split(found->second.front(), ',');
    given = std::min(parts.size(), colors.size());
    for (std::size_t i = 0; i < given; ++i) colors[i] = parse_color(parts[i]).value_or(colors[i]);
  }
  for (std::size_t i = 0; i < colors.size(); ++i) {
    if (i > 0) ImGui::SameLine();
    const bool changed = color_swatch(kTitles[i], colors[i], is_held_);
    log_.note_widget(std::string("color ") + kTitles[i]);
    if (!changed) continue;
    std::string text;
    for (std::size_t j = 0; j < std::max(given, i + 1); ++j) {
      text += (j > 0 ? "," : "") + hex_color(colors[j]);
    }
    set(option, {text}, ValueChange::dragged);
  }
}

}  // namespace brindle::tool
