/// What the window did, one line of JSON each, for bug reports and tests.
#pragma once

#include <filesystem>
#include <fstream>
#include <map>
#include <string>

#include <nlohmann/json.hpp>

namespace brindle::tool {

/// A rectangle of Dear ImGui's units, from the window's upper left corner.
struct WidgetPlace {
  int x = 0;
  int y = 0;
  int width = 0;
  int height = 0;

  bool operator==(const WidgetPlace&) const = default;
};

/// Writes every line at once, so that a log is whole up to the moment at which a program dies.
/// Without a file it does nothing.
class WindowLog {
 public:
  WindowLog() = default;
  /// Throws Error if the file cannot be written.
  explicit WindowLog(const std::filesystem::path& path);

  bool is_open() const { return file_.is_open(); }

  /// {"time": seconds, "event": name, ...}
  void write(const std::string& event, nlohmann::ordered_json details = {});

  /// Notes where the last widget of Dear ImGui is.
  void note_widget(const std::string& name);

  /// The same of something that is drawn there.
  void note_place(const std::string& name, const WidgetPlace& place);

  /// Writes which widgets have appeared, moved or gone since the last frame, if any.
  void end_frame();

 private:
  std::ofstream file_;
  double start_ = 0;
  std::map<std::string, WidgetPlace> shown_;
  std::map<std::string, WidgetPlace> last_shown_;
};

}  // namespace brindle::tool
