/// A log of the window's events, one line of JSON each, for bug reports and tests.
#pragma once

#include <filesystem>
#include <fstream>
#include <map>
#include <string>

#include <nlohmann/json.hpp>

namespace brindle::tool {

/// A rectangle in Dear ImGui units, from the window's upper left corner.
struct WidgetPlace {
  int x = 0;
  int y = 0;
  int width = 0;
  int height = 0;

  bool operator==(const WidgetPlace&) const = default;
};

/// Flushes every line, so that the log is complete after a crash. Does nothing without a file.
class WindowLog {
 public:
  WindowLog() = default;
  /// Throws Error if the file cannot be written.
  explicit WindowLog(const std::filesystem::path& path);

  bool is_open() const { return file_.is_open(); }

  /// {"time": seconds, "event": name, ...}
  void write(const std::string& event, nlohmann::ordered_json details = {});

  /// Logs the position of Dear ImGui's last widget.
  void note_widget(const std::string& name);

  /// The same for a drawn item.
  void note_place(const std::string& name, const WidgetPlace& place);

  /// Logs widgets that appeared, moved or disappeared since the last frame.
  void end_frame();

 private:
  std::ofstream file_;
  double start_ = 0;
  std::map<std::string, WidgetPlace> shown_;
  std::map<std::string, WidgetPlace> last_shown_;
};

}  // namespace brindle::tool
