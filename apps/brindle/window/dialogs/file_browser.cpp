#include "window/dialogs/file_browser.h"

#include <algorithm>
#include <cfloat>
#include <utility>

#include <imgui.h>
#include <imgui_stdlib.h>

#include "brindle/base/file_names.h"
#include "brindle/base/text.h"

namespace brindle::tool {
namespace {

namespace fs = std::filesystem;

constexpr const char* kDialogue = "###file_browser";

std::string size_text(std::uintmax_t bytes) {
  const auto with_unit = [](std::uintmax_t count, const char* unit) {
    return std::to_string(count) + unit;
  };
  if (bytes < 10'000) return with_unit(bytes, " B");
  if (bytes < 10'000'000) return with_unit(bytes / 1000, " kB");
  return with_unit(bytes / 1'000'000, " MB");
}

std::string joined(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : " ") + word;
  return text;
}

// The folder of a path, or the current folder if that no longer exists.
fs::path existing_folder(fs::path folder) {
  std::error_code error;
  while (!folder.empty() && !fs::is_directory(folder, error) && folder != folder.parent_path()) {
    folder = folder.parent_path();
  }
  if (folder.empty() || !fs::is_directory(folder, error)) folder = fs::current_path(error);
  return folder;
}

}  // namespace

FileBrowser::FileBrowser(fs::path folder) : folder_(existing_folder(std::move(folder))) {}

void FileBrowser::ask(FileRequest request) {
  request_ = std::move(request);
  name_ = request_->name;
  newly_asked_ = takes_keys_ = true;
  show_all_ = request_->extensions.empty();
  enter(existing_folder(folder_));
}

bool FileBrowser::fits(const std::string& name) const {
  if (show_all_) return true;
  return std::ranges::find(request_->extensions, lower_extension(name)) !=
         request_->extensions.end();
}

void FileBrowser::enter(const fs::path& folder) {
  std::error_code error;
  const fs::path whole = fs::weakly_canonical(folder, error);
  fs::directory_iterator entries(whole, fs::directory_options::skip_permission_denied, error);
  if (error) {
    problem_ = shown(folder.native()) + ": " + error.message();
    return;
  }
  items_.clear();
  for (const fs::directory_entry& entry : entries) {
    std::error_code ignored;
    Item item{entry.path().filename().string(), entry.is_directory(ignored)};
    if (item.name.starts_with('.')) continue;
    if (!item.is_folder) item.bytes = entry.file_size(ignored);
    items_.push_back(std::move(item));
  }
  std::ranges::sort(items_, [](const Item& a, const Item& b) {
    return std::tie(b.is_folder, a.name) < std::tie(a.is_folder, b.name);
  });
  folder_ = whole;
  problem_.clear();
  confirm_ = false;
}

void FileBrowser::draw(WindowLog& log) {
  if (!request_) return;
  const std::string title = request_->title + kDialogue;
  if (newly_asked_) ImGui::OpenPopup(title.c_str());
  const ImGuiViewport* viewport = ImGui::GetMainViewport();
  const ImVec2 center(viewport->WorkPos.x + viewport->WorkSize.x / 2,
                      viewport->WorkPos.y + viewport->WorkSize.y / 2);
  const float text = ImGui::GetFontSize();
  ImGui::SetNextWindowPos(center, ImGuiCond_Appearing, {0.5f, 0.5f});
  ImGui::SetNextWindowSize({std::min(44 * text, viewport->WorkSize.x * 0.9f),
                            std::min(30 * text, viewport->WorkSize.y * 0.9f)},
                           ImGuiCond_Appearing);
  bool open = true;
  if (!ImGui::BeginPopupModal(title.c_str(), &open, ImGuiWindowFlags_NoCollapse)) return close();
  if (ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape))) open = false;
  draw_path(log);
  draw_items(log);
  draw_buttons(log);
  if (!open || !request_) {
    ImGui::CloseCurrentPopup();
    close();
  }
  newly_asked_ = false;
  ImGui::EndPopup();
}

// A button per folder.
void FileBrowser::draw_path(WindowLog& log) {
  fs::path part;
  fs::path chosen;
  for (const fs::path& name : folder_) {
    part /= name;
    const std::string label = (name == "/" ? "/" : name.string()) + "##" + part.string();
    if (!part.has_relative_path()) {
      if (ImGui::Button(label.c_str())) chosen = part;
      continue;
    }
    ImGui::SameLine(0, 2);
    const float needed = ImGui::CalcTextSize(name.c_str()).x + ImGui::GetFontSize();
    if (ImGui::GetContentRegionAvail().x < needed) ImGui::NewLine();
    if (ImGui::Button(label.c_str())) chosen = part;
  }
  log.note_widget("browser folder");
  if (!chosen.empty()) enter(chosen);
}

void FileBrowser::draw_items(WindowLog& log) {
  const float below = 3.4f * ImGui::GetFrameHeightWithSpacing() +
                      (problem_.empty() && !confirm_ ? 0 : 2 * ImGui::GetTextLineHeight());
  fs::path folder;
  std::string file;
  ImGui::BeginChild("items", {0, -below}, true);
  const float size_column = ImGui::GetContentRegionAvail().x - 5 * ImGui::GetFontSize();
  for (const Item& item : items_) {
    if (!item.is_folder && !fits(item.name)) continue;
    const std::string label = item.is_folder ? item.name + "/" : item.name;
    if (ImGui::Selectable(
            label.c_str(), item.name == name_,
            ImGuiSelectableFlags_AllowDoubleClick | ImGuiSelectableFlags_DontClosePopups)) {
      if (item.is_folder) {
        folder = folder_ / item.name;
      } else {
        name_ = item.name;
        confirm_ = false;
        if (ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left)) file = item.name;
      }
    }
    log.note_widget("browser item " + item.name);
    if (item.is_folder) continue;
    ImGui::SameLine(size_column);
    ImGui::TextDisabled("%s", size_text(item.bytes).c_str());
  }
  ImGui::EndChild();
  if (!folder.empty()) enter(folder);
  if (!file.empty()) choose(file);
}

void FileBrowser::draw_buttons(WindowLog& log) {
  ImGui::SetNextItemWidth(-FLT_MIN);
  if (std::exchange(takes_keys_, false)) ImGui::SetKeyboardFocusHere();
  const bool entered = ImGui::InputTextWithHint("##name", "name or path", &name_,
                                                ImGuiInputTextFlags_EnterReturnsTrue);
  log.note_widget("browser name");
  if (ImGui::IsItemEdited()) confirm_ = false;
  if (!request_->extensions.empty()) {
    ImGui::Checkbox("all files", &show_all_);
    ImGui::SameLine();
    ImGui::TextDisabled("%s", joined(request_->extensions).c_str());
  }
  if (!problem_.empty()) {
    ImGui::TextWrapped("%s", problem_.c_str());
    log.note_widget("browser problem");
  }
  if (confirm_) ImGui::TextWrapped("%s is there already.", name_.c_str());
  const std::string verb = !request_->save ? "Open" : confirm_ ? "Replace it" : request_->verb;
  ImGui::BeginDisabled(name_.empty());
  const bool pressed = ImGui::Button(verb.c_str());
  ImGui::EndDisabled();
  log.note_widget("browser done");
  ImGui::SameLine();
  const bool cancelled = ImGui::Button("Cancel");
  log.note_widget("browser cancel");
  if (cancelled) {
    request_.reset();
  } else if ((entered || pressed) && !name_.empty()) {
    choose(name_);
    takes_keys_ = true;
  }
}

// `name` may be a path, also of a folder.
void FileBrowser::choose(const std::string& name) {
  fs::path path = folder_ / name;
  std::error_code ignored;
  if (fs::is_directory(path, ignored)) {
    name_.clear();
    return enter(path);
  }
  if (!request_->save) {
    if (!fs::exists(path, ignored)) {
      problem_ = shown(path.native()) + ": there is no such file";
      return;
    }
    return finish(path);
  }
  if (!path.has_extension() && !request_->extensions.empty()) {
    path += request_->extensions.front();
    name_ = name + request_->extensions.front();
  }
  problem_ = refusal(path);
  if (!problem_.empty()) return;
  if (fs::exists(path, ignored) && !confirm_) {
    confirm_ = true;
    return;
  }
  finish(path);
}

// The format follows from the name, so other extensions are rejected.
std::string FileBrowser::refusal(const fs::path& path) const {
  const std::vector<std::string>& known = request_->extensions;
  std::string why;
  if (request_->refusal) {
    why = request_->refusal(path);
  } else if (!known.empty() && std::ranges::find(known, lower_extension(path)) == known.end()) {
    why = "'" + path.extension().string() + "' is not written here; write " + joined(known);
  }
  return why.empty() ? "" : "cannot write '" + path.string() + "': " + why;
}

void FileBrowser::finish(const fs::path& path) {
  folder_ = path.parent_path();
  const auto done = std::move(request_->done);
  request_.reset();
  done(path);
}

void FileBrowser::close() {
  request_.reset();
  problem_.clear();
  confirm_ = false;
}

}  // namespace brindle::tool
