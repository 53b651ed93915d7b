#include "window/panels/gallery_menu.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <random>
#include <utility>

#include <imgui.h>

#include "brindle/base/text.h"
#include "brindle/error.h"
#include "brindle/version.h"
#include "cli/option_values.h"
#include "session/session_words.h"
#include "window/base/value_slider.h"

namespace brindle::tool {
namespace {

namespace fs = std::filesystem;

constexpr double kTilesASecond = 1;

fs::path cache_folder() {
  const char* cache = std::getenv("XDG_CACHE_HOME");
  if (cache != nullptr && *cache == '/') return cache;
  const char* home = std::getenv("HOME");
  if (home != nullptr && *home == '/') return fs::path(home) / ".cache";
  std::error_code ignored;
  return fs::temp_directory_path(ignored);
}

// The files numbered like "step_007.vtp" in its folder.
struct Steps {
  fs::path folder;
  int number = 0;
  int count = 0;  // less than two: no series

  fs::path path(int step) const { return folder / formatted("step_%03d.vtp", step); }
};

Steps steps_beside(const fs::path& mesh) {
  Steps steps{mesh.parent_path()};
  if (std::sscanf(mesh.filename().c_str(), "step_%3d.vtp", &steps.number) != 1) return steps;
  std::error_code ignored;
  while (steps.count < 1000 && fs::exists(steps.path(steps.count), ignored)) ++steps.count;
  return steps;
}

}  // namespace

fs::path gallery_folder() {
  return cache_folder() / "brindle" / ("gallery-" + std::string(BRINDLE_VERSION));
}

fs::path provide_gallery_data(const GalleryItem& item, const fs::path& folder) {
  const fs::path data = folder / item.name;
  std::error_code error;
  if (fs::exists(data, error)) return data;
  const fs::path unfinished =
      folder / (item.name + ".tmp" + std::to_string(std::random_device()()));
  fs::create_directories(unfinished, error);
  if (error) {
    throw Error("cannot make the folder '" + shown(unfinished.native()) + "': " + error.message() +
                "; set XDG_CACHE_HOME to one that can be written to");
  }
  try {
    write_gallery_files(unfinished.string(), item.make(1, {}));
    fs::rename(unfinished, data);
  } catch (const std::exception& failure) {
    fs::remove_all(unfinished, error);
    if (fs::exists(data, error)) return data;  // another window was faster
    throw Error("the gallery's data: " + std::string(failure.what()));
  }
  return data;
}

void GalleryMenu::draw_menu() {
  for (const GalleryItem& item : gallery_items()) {
    const bool open = ImGui::BeginMenu(item.name.c_str());
    log_.note_widget("item " + item.name);
    if (!open) {
      if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s", item.what.c_str());
      continue;
    }
    for (const GalleryPicture& picture : item.pictures) {
      if (!is_still_picture(picture)) continue;
      if (ImGui::MenuItem((picture.name + ": " + picture.what).c_str())) show(item, picture);
      log_.note_widget("item " + item.name + " " + picture.name);
    }
    ImGui::EndMenu();
  }
}

// Data are made in the background.
void GalleryMenu::show(const GalleryItem& item, const GalleryPicture& picture) {
  const fs::path folder = gallery_folder();
  std::error_code ignored;
  if (!fs::exists(folder / item.name, ignored)) {
    live_.add_message(MessageKind::note, "making the data of '" + item.name + "' in " +
                                             shown((folder / item.name).native()) + " ...");
  }
  jobs_.start(
      [&item, folder] {
        provide_gallery_data(item, folder);
        return std::string();
      },
      [this, &item, &picture, folder] {
        load(item.name + ", " + picture.name, picture, folder / item.name);
      });
}

void GalleryMenu::load(const std::string& name, const GalleryPicture& picture,
                       const fs::path& data) {
  SessionDocument document = document_of_words(filled_words(picture, {data.string(), "", "", ""}));
  document.size = live_.document().size;
  open_(document, "'" + name + "' of the gallery",
        [this, name, &picture, document] { take(name, picture, document); });
}

void GalleryMenu::take(const std::string& name, const GalleryPicture& picture,
                       const SessionDocument& document) {
  mesh_ = document.mesh;
  if (!live_.apply(commands::load(document))) return;
  live_.note_saved();
  shown_ = &picture;
  title_ = "Gallery: " + name;
  flows_ = false;
  live_.add_message(MessageKind::note, picture.what);
}

void GalleryMenu::draw_panel() {
  if (shown_ == nullptr) return;
  const fs::path mesh = live_.document().mesh;
  if (mesh.parent_path() != fs::path(mesh_).parent_path()) return;
  const bool open =
      ImGui::CollapsingHeader((title_ + "###gallery").c_str(), ImGuiTreeNodeFlags_DefaultOpen);
  log_.note_widget("group Gallery");
  if (!open) return;
  ImGui::PushID("gallery");
  draw_steps();
  for (const std::string& name : shown_->live) {
    options_.draw_option(name);
    if (name == "texture-shift") draw_flow();
  }
  ImGui::PopID();
}

// Chooses a mesh of a series.
void GalleryMenu::draw_steps() {
  const Steps steps = steps_beside(live_.document().mesh);
  if (steps.count < 2) return;
  auto step = static_cast<float>(steps.number);
  ImGui::SetNextItemWidth(0.6f * ImGui::GetContentRegionAvail().x);
  const ValueChange change =
      value_slider("step", step, 0, static_cast<float>(steps.count - 1), "%.0f");
  log_.note_widget("gallery step");
  const float whole = std::round(step);
  if (change == ValueChange::none || whole == static_cast<float>(steps.number)) return;
  const bool is_there = whole >= 0 && whole < static_cast<float>(steps.count);
  if (change == ValueChange::typed && !(is_there && step == whole)) {
    return live_.add_message(MessageKind::error,
                             formatted("there are steps from 0 to %d", steps.count - 1));
  }
  live_.apply_value(change, commands::open(steps.path(static_cast<int>(whole)).string(), true));
}

void GalleryMenu::draw_flow() {
  if (ImGui::Checkbox("tiles flow", &flows_)) flowed_at_ = ImGui::GetTime();
  log_.note_widget("gallery flow");
}

bool GalleryMenu::update() {
  if (!flows_ || live_.worker().busy()) return flows_;
  const auto found = live_.document().options.find("texture-shift");
  const std::string text = found == live_.document().options.end() ? "0" : found->second.front();
  const double now = ImGui::GetTime();
  const double shift = std::atof(split(text, ',').front().c_str()) +
                       kTilesASecond * (now - std::exchange(flowed_at_, now));
  const std::string next = formatted("%.4f", shift - std::floor(shift));
  if (next != text && !live_.apply_moving(commands::set_option("texture-shift", {next}))) {
    flows_ = false;
  }
  return flows_;
}

}  // namespace brindle::tool
