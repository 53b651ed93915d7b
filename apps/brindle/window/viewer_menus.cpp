// Menus and keys of the window.

#include <algorithm>
#include <array>
#include <cctype>
#include <string>
#include <utility>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <imgui.h>

#include "brindle/error.h"
#include "brindle/render/parsed_words.h"
#include "brindle/version.h"
#include "pictures/drawing_file.h"
#include "session/session_export.h"
#include "window/viewer.h"

namespace brindle::tool {
namespace {

constexpr std::array kViews = {"stripes", "branches", "angle_error"};

constexpr std::array<std::pair<const char*, const char*>, 32> kKeys = {{
    {"drag", "turn"},
    {"Shift + drag, middle drag", "move"},
    {"wheel", "zoom"},
    {"double click", "this point in the middle; beside the surface: the whole surface"},
    {"1 ... 9", "recall a view"},
    {"Ctrl + 1 ... 9", "store the view"},
    {"Home", "see the whole surface"},
    {"Alt + Left, Alt + Right", "the view before, and back again"},
    {"O", "orthographic or perspective"},
    {"T", "turntable or free"},
    {"Ctrl + C, Ctrl + V", "copy and paste the view as JSON"},
    {"B", "stripes, branches, angle errors, curves, samples"},
    {"I", "move the light"},
    {"V C S M E", "look, comb, spline, move and erase strokes"},
    {"G", "steer singularities"},
    {"F", "the place of distances follows the mouse, or not"},
    {"Enter", "end the spline"},
    {"Delete", "erase the chosen stroke"},
    {"N", "solve again, whatever stripes have followed"},
    {"Ctrl + Z", "undo"},
    {"Ctrl + Shift + Z, Ctrl + Y", "redo"},
    {"Ctrl + O", "open a mesh or a session"},
    {"Ctrl + S", "save the session"},
    {"Ctrl + P", "save the picture as it is"},
    {"Ctrl + Shift + P", "export it: size, format, background"},
    {"R", "start or stop recording"},
    {"Tab", "show or hide the panels"},
    {"L", "light or dark"},
    {"Ctrl + click on a slider", "type a number"},
    {"right click on a name", "leave the option out, or type its value"},
    {"F12", "write a mark into the log (--log)"},
    {"Ctrl + Q", "quit"},
}};

// The last folders of a path and its name, to keep menus narrow.
std::string end_of_path(const std::string& path) {
  constexpr std::size_t kLongest = 40;
  if (path.size() <= kLongest) return path;
  const std::size_t slash = path.find('/', path.size() - kLongest);
  return "..." + path.substr(slash == path.npos ? path.rfind('/') + 1 : slash);
}

}  // namespace

bool Viewer::item(const char* label, const char* keys, bool chosen, bool enabled) {
  const bool clicked = ImGui::MenuItem(label, keys, chosen, enabled);
  log_.note_widget(std::string("item ") + label);
  return clicked;
}

void Viewer::draw_menus() {
  if (!ImGui::BeginMainMenuBar()) return;
  const auto menu = [this](const char* name, void (Viewer::*contents)()) {
    const bool open = ImGui::BeginMenu(name);
    log_.note_widget(std::string("menu ") + name);
    if (!open) return;
    (this->*contents)();
    ImGui::EndMenu();
  };
  menu("File", &Viewer::draw_file_menu);
  menu("Edit", &Viewer::draw_edit_menu);
  menu("View", &Viewer::draw_view_menu);
  menu("Gallery", &Viewer::draw_gallery_menu);
  menu("Help", &Viewer::draw_help_menu);
  ImGui::EndMainMenuBar();
}

void Viewer::draw_file_menu() {
  if (item("Open...", "Ctrl+O")) ask_open();
  draw_recent_menu();
  draw_shape_menu();
  ImGui::Separator();
  draw_save_items();
  ImGui::Separator();
  draw_export_items();
  ImGui::Separator();
  if (item("Quit", "Ctrl+Q")) window_.ask_to_close();
}

void Viewer::draw_recent_menu() {
  const bool open = ImGui::BeginMenu("Open recent", !settings_.recent.empty());
  log_.note_widget("item Open recent");
  if (!open) return;
  std::string chosen;
  for (const std::string& name : settings_.recent) {
    if (ImGui::MenuItem((end_of_path(name) + "###" + name).c_str())) chosen = name;
    log_.note_widget("item " + name);
    if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s", name.c_str());
  }
  ImGui::EndMenu();
  if (!chosen.empty()) this->open(chosen);
}

void Viewer::draw_shape_menu() {
  const bool open = ImGui::BeginMenu("Shape");
  log_.note_widget("item Shape");
  if (!open) return;
  for (const ShapeInfo& shape : shapes_.shapes()) {
    if (item(shape.name.c_str(), nullptr)) open_mesh(shape_text(shape, {}));
    if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s", shape.help.c_str());
  }
  ImGui::Separator();
  if (item("Parameters...", nullptr)) shapes_.open();
  ImGui::EndMenu();
}

void Viewer::draw_save_items() {
  if (item("Save session", "Ctrl+S")) {
    session_file_.empty() ? ask_save_session() : save_session(session_file_);
  }
  if (item("Save session as...", nullptr)) ask_save_session();
  if (item("Save picture...", "Ctrl+P")) ask_save_picture();
  if (item("Export picture...", "Ctrl+Shift+P")) export_.open(stem() + ".png");
  if (item("Save picture of the window...", nullptr)) ask_save_window();
  if (item(recording_ ? "Stop recording" : "Record a video...", "R")) toggle_recording();
}

void Viewer::draw_export_items() {
  const Shown shown = live_.document().shown;
  if (item("Export mesh...", nullptr)) {
    ask_export("Export the mesh", {".vtp", ".ply", ".obj", ".glb", ".gltf"}, export_pattern);
  }
  if (item("Export curves...", nullptr)) {
    std::vector<std::string> files = {".vtp", ".ply", ".obj", ".csv"};
    if (shown == Shown::curves) files.insert(files.end(), {".glb", ".gltf", ".json", ".svg"});
    if (shown == Shown::curves && drawing_refusal("a.pdf").empty()) files.push_back(".pdf");
    ask_export("Export the stripes' curves", std::move(files), export_curves);
  }
  if (item("Export samples...", nullptr)) {
    ask_export("Export samples", {".csv", ".ply", ".vtp"}, export_samples);
  }
  ImGui::Separator();
  const bool has_strokes = !live_.document().strokes.empty();
  if (item("Load strokes...", nullptr)) ask_strokes(false);
  const bool has_any = !all_strokes(live_.document()).empty();
  if (item("Save strokes...", nullptr, false, has_any)) ask_strokes(true);
  if (item("Erase all strokes", nullptr, false, has_strokes))
    live_.apply(commands::set_strokes({}));
}

void Viewer::draw_edit_menu() {
  const Session& session = live_.session();
  const std::string undo = "Undo " + session.undo_name() + "###Undo";
  const std::string redo = "Redo " + session.redo_name() + "###Redo";
  if (ImGui::MenuItem(undo.c_str(), "Ctrl+Z", false, session.can_undo())) live_.undo();
  log_.note_widget("item Undo");
  if (ImGui::MenuItem(redo.c_str(), "Ctrl+Shift+Z", false, session.can_redo())) live_.redo();
  log_.note_widget("item Redo");
  ImGui::Separator();
  if (item("Solve again", "N")) solve_again();
  ImGui::Separator();
  if (item("Copy view", "Ctrl+C")) window_.set_clipboard(view_text(live_.document().camera));
  if (item("Paste view", "Ctrl+V")) paste_view();
}

void Viewer::draw_view_menu() {
  const CameraView& view = live_.document().camera;
  if (item("See everything", "Home")) set_camera({.projection = view.projection});
  const Session& session = live_.session();
  if (item("Previous view", "Alt+Left", false, session.has_previous_view())) live_.previous_view();
  if (item("Next view", "Alt+Right", false, session.has_next_view())) live_.next_view();
  draw_side_items();
  draw_stored_views();
  ImGui::Separator();
  const bool stripes = live_.document().shown == Shown::stripes;
  const auto& options = live_.document().options;
  const auto found = options.find("view");
  const std::string current = found == options.end() ? "stripes" : found->second.front();
  for (const char* name : kViews) {
    if (item(name, "B", stripes && current == name)) show_view(name);
  }
  for (const Shown shown : {Shown::curves, Shown::samples}) {
    const bool now = live_.document().shown == shown;
    if (item(std::string(name_of(shown)).c_str(), "B", now)) live_.apply(commands::show(shown));
  }
  ImGui::Separator();
  if (item("Options", "Tab", settings_.show_options)) {
    settings_.show_options = !settings_.show_options;
  }
  if (item("Metrics", "Tab", settings_.show_metrics)) {
    settings_.show_metrics = !settings_.show_metrics;
  }
  if (item("Dark", "L", window_.dark())) toggle_theme();
}

void Viewer::draw_side_items() {
  const bool open = ImGui::BeginMenu("From");
  log_.note_widget("item From");
  if (!open) return;
  for (const ViewSide& side : kViewSides) {
    std::string name(side.name);
    name.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(name.front())));
    if (item(name.c_str(), nullptr)) {
      set_camera(from_side(live_.document().camera, side.azimuth_deg, side.elevation_deg));
    }
  }
  ImGui::EndMenu();
}

void Viewer::draw_stored_views() {
  const bool open = ImGui::BeginMenu("Stored views");
  log_.note_widget("item Stored views");
  if (!open) return;
  for (int key = 1; key <= kStoredViews; ++key) {
    const std::string number = std::to_string(key);
    const bool stored = live_.document().views[static_cast<std::size_t>(key) - 1].has_value();
    if (item(("Recall " + number).c_str(), number.c_str(), false, stored)) {
      live_.apply(commands::recall_view(key));
    }
  }
  ImGui::Separator();
  for (int key = 1; key <= kStoredViews; ++key) {
    const std::string number = std::to_string(key);
    if (item(("Store as " + number).c_str(), ("Ctrl+" + number).c_str())) {
      live_.apply(commands::store_view(key));
    }
  }
  ImGui::EndMenu();
}

void Viewer::draw_help_menu() {
  if (item("Keys", "?")) show_keys_ = true;
  ImGui::Separator();
  ImGui::TextDisabled("Brindle " BRINDLE_VERSION);
  ImGui::TextDisabled("%s", window_.renderer().c_str());
}

void Viewer::draw_keys() {
  if (!show_keys_) return;
  ImGui::SetNextWindowPos(ImGui::GetMainViewport()->GetCenter(), ImGuiCond_Appearing, {0.5f, 0.5f});
  if (ImGui::Begin("Keys and mouse", &show_keys_,
                   ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoCollapse)) {
    for (const auto& [keys, what] : kKeys) {
      ImGui::TextUnformatted(keys);
      ImGui::SameLine(14 * ImGui::GetFontSize());
      ImGui::TextDisabled("%s", what);
    }
  }
  log_.note_widget("keys");
  ImGui::End();
}

void Viewer::follow_keys() {
  const bool typing =
      ImGui::GetIO().WantTextInput || browser_.is_open() || export_.is_open() || question_;
  for (const PressedKey& key : window_.take_keys()) {
    // Logged after widgets have processed all earlier input, which takes two frames.
    if (key.key == GLFW_KEY_F12) frames_to_mark_ = 2;
    if (typing) continue;
    if (key.key == GLFW_KEY_ESCAPE && window_.close_popup()) continue;
    if (key.alt) {
      follow_alt_key(key);
    } else {
      key.control ? follow_control_key(key) : follow_plain_key(key);
    }
  }
}

void Viewer::follow_alt_key(const PressedKey& key) {
  if (key.key == GLFW_KEY_LEFT) live_.previous_view();
  if (key.key == GLFW_KEY_RIGHT) live_.next_view();
}

void Viewer::follow_control_key(const PressedKey& key) {
  if (key.key >= GLFW_KEY_1 && key.key <= GLFW_KEY_9) {
    live_.apply(commands::store_view(key.key - GLFW_KEY_1 + 1));
    return live_.add_message(MessageKind::note, "the view is stored under " +
                                                    std::string(1, static_cast<char>(key.key)));
  }
  switch (key.key) {
    case GLFW_KEY_Z:
      key.shift ? live_.redo() : live_.undo();
      return;
    case GLFW_KEY_Y:
      live_.redo();
      return;
    case GLFW_KEY_O:
      return ask_open();
    case GLFW_KEY_S:
      return session_file_.empty() || key.shift ? ask_save_session() : save_session(session_file_);
    case GLFW_KEY_P:
      return key.shift ? export_.open(stem() + ".png") : ask_save_picture();
    case GLFW_KEY_C:
      return window_.set_clipboard(view_text(live_.document().camera));
    case GLFW_KEY_V:
      return paste_view();
    case GLFW_KEY_Q:
      return window_.ask_to_close();
    default:
      return;
  }
}

void Viewer::follow_plain_key(const PressedKey& key) {
  if (key.key >= GLFW_KEY_1 && key.key <= GLFW_KEY_9) {
    live_.apply(commands::recall_view(key.key - GLFW_KEY_1 + 1));
    return;
  }
  const CameraView& view = live_.document().camera;
  switch (key.key) {
    case GLFW_KEY_HOME:
      return set_camera({.projection = view.projection});
    case GLFW_KEY_O:
      return set_camera(with_other_projection(view));
    case GLFW_KEY_T:
      return set_camera(view.rotation ? upright(view) : freed(view));
    case GLFW_KEY_TAB:
      settings_.show_options = settings_.show_metrics = !settings_.show_options;
      return;
    case GLFW_KEY_ESCAPE:
      show_keys_ = false;
      [[fallthrough]];
    case GLFW_KEY_ENTER:
      tool_.finish_spline();
      return;
    case GLFW_KEY_DELETE:
      tool_.erase_chosen();
      return;
    case '?':
      show_keys_ = !show_keys_;
      return;
    default:
      return follow_letter(key.key);
  }
}

void Viewer::follow_letter(int key) {
  switch (key) {
    case GLFW_KEY_V:
      return tool_.choose(Tool::look);
    case GLFW_KEY_I:
      return tool_.choose(Tool::light);
    case GLFW_KEY_C:
      return tool_.choose(Tool::comb);
    case GLFW_KEY_S:
      return tool_.choose(Tool::spline);
    case GLFW_KEY_M:
      return tool_.choose(Tool::move);
    case GLFW_KEY_E:
      return tool_.choose(Tool::erase);
    case GLFW_KEY_G:
      return tool_.choose(Tool::steer);
    case GLFW_KEY_B:
      return cycle_view();
    case GLFW_KEY_F:
      return places_.set_follows(!places_.follows());
    case GLFW_KEY_N:
      return solve_again();
    case GLFW_KEY_R:
      return toggle_recording();
    case GLFW_KEY_L:
      return toggle_theme();
    default:
      return;
  }
}

void Viewer::set_camera(const CameraView& view) { live_.apply(commands::set_camera(view)); }

void Viewer::solve_again() {
  if (live_.at_rest() && live_.frame()->state->phases == nullptr) {
    return live_.add_message(MessageKind::note, "the pattern has followed no other one");
  }
  live_.end_drag();
  live_.apply(session_command("solve_again"));
}

void Viewer::paste_view() {
  try {
    set_camera(parse_view_text(window_.clipboard()));
  } catch (const std::exception& error) {
    live_.add_message(MessageKind::error, error.what());
  }
}

void Viewer::show_view(const std::string& name) {
  if (live_.document().shown != Shown::stripes) live_.apply(commands::show(Shown::stripes));
  if (name == kViews.front()) {
    live_.apply(commands::clear_option("view"));
  } else {
    live_.apply(commands::set_option("view", {name}));
  }
}

void Viewer::cycle_view() {
  const auto& options = live_.document().options;
  const auto found = options.find("view");
  const std::string current = found == options.end() ? kViews.front() : found->second.front();
  const auto at = std::ranges::find(kViews, current);
  switch (live_.document().shown) {
    case Shown::stripes:
      if (at != kViews.end() && at + 1 != kViews.end()) return show_view(*(at + 1));
      live_.apply(commands::show(Shown::curves));
      return;
    case Shown::curves:
      live_.apply(commands::show(Shown::samples));
      return;
    case Shown::samples:
      return show_view(kViews.front());
  }
}

void Viewer::toggle_theme() {
  window_.set_dark(!window_.dark());
  settings_.dark = window_.dark();
}

}  // namespace brindle::tool
