#include "window/base/window_log.h"

#include <chrono>
#include <cmath>
#include <utility>

#include <imgui.h>

#include "brindle/base/text.h"
#include "brindle/error.h"

namespace brindle::tool {
namespace {

double log_seconds() {
  using Seconds = std::chrono::duration<double>;
  return Seconds(std::chrono::steady_clock::now().time_since_epoch()).count();
}

WidgetPlace last_place() {
  const ImVec2 first = ImGui::GetItemRectMin();
  const ImVec2 last = ImGui::GetItemRectMax();
  const auto rounded = [](float value) { return static_cast<int>(std::lround(value)); };
  return {rounded(first.x), rounded(first.y), rounded(last.x - first.x), rounded(last.y - first.y)};
}

}  // namespace

WindowLog::WindowLog(const std::filesystem::path& path) : file_(path), start_(log_seconds()) {
  if (!file_) {
    throw Error(shown(path.native()) +
                ": cannot be written; choose a folder that is there and yours");
  }
}

void WindowLog::write(const std::string& event, nlohmann::ordered_json details) {
  if (!is_open()) return;
  const double milliseconds = std::round((log_seconds() - start_) * 1000);
  nlohmann::ordered_json line = {{"time", milliseconds / 1000}, {"event", event}};
  if (details.is_object()) line.update(details);
  // File names may be invalid UTF-8.
  file_ << line.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace) << std::endl;
}

void WindowLog::note_widget(const std::string& name) {
  if (is_open() && ImGui::IsItemVisible()) shown_[name] = last_place();
}

void WindowLog::note_place(const std::string& name, const WidgetPlace& place) {
  if (is_open()) shown_[name] = place;
}

void WindowLog::end_frame() {
  if (!is_open()) return;
  auto changed = nlohmann::ordered_json::object();
  for (const auto& [name, place] : shown_) {
    const auto last = last_shown_.find(name);
    if (last != last_shown_.end() && last->second == place) continue;
    changed[name] = {place.x, place.y, place.width, place.height};
  }
  for (const auto& [name, place] : last_shown_) {
    if (!shown_.contains(name)) changed[name] = nullptr;
  }
  if (!changed.empty()) write("widgets", {{"places", changed}});
  last_shown_ = std::exchange(shown_, {});
}

}  // namespace brindle::tool
