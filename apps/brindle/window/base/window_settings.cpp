#include "window/base/window_settings.h"

#include <algorithm>
#include <cstdlib>
#include <fstream>

#include <nlohmann/json.hpp>

#include "brindle/base/output_file.h"

namespace brindle::tool {
namespace {

constexpr std::size_t kMostRecent = 12;

// The value of a key, or its default.
template <class Value>
void take(const nlohmann::json& json, const char* key, Value& value) {
  const auto found = json.find(key);
  if (found == json.end()) return;
  try {
    found->get_to(value);
  } catch (const nlohmann::json::exception&) {
    // Settings are optional: a damaged file is ignored.
  }
}

std::string as_listed(const std::string& opened) {
  std::error_code ignored;
  return opened.starts_with("shape:") ? opened
                                      : std::filesystem::absolute(opened, ignored).string();
}

}  // namespace

std::filesystem::path settings_path() {
  const char* config = std::getenv("XDG_CONFIG_HOME");
  if (config != nullptr && *config == '/') {
    return std::filesystem::path(config) / "brindle" / "window.json";
  }
  const char* home = std::getenv("HOME");
  if (home == nullptr || *home == '\0') return {};
  return std::filesystem::path(home) / ".config" / "brindle" / "window.json";
}

WindowSettings read_settings(const std::filesystem::path& path) {
  WindowSettings settings;
  std::ifstream file(path);
  const auto json = nlohmann::json::parse(file, nullptr, false);
  if (!json.is_object()) return settings;
  take(json, "recent", settings.recent);
  take(json, "dark", settings.dark);
  take(json, "show_options", settings.show_options);
  take(json, "show_metrics", settings.show_metrics);
  take(json, "folder", settings.folder);
  if (settings.recent.size() > kMostRecent) settings.recent.resize(kMostRecent);
  return settings;
}

void write_settings(const std::filesystem::path& path, const WindowSettings& settings) {
  if (path.empty()) return;
  std::error_code ignored;  // `write_file` reports the error
  std::filesystem::create_directories(path.parent_path(), ignored);
  const nlohmann::ordered_json json = {{"recent", settings.recent},
                                       {"dark", settings.dark},
                                       {"show_options", settings.show_options},
                                       {"show_metrics", settings.show_metrics},
                                       {"folder", settings.folder}};
  write_file(path, [&](OutputStream& out) {
    out << json.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) << '\n';
  });
}

bool forget(WindowSettings& settings, const std::string& unread) {
  return std::erase(settings.recent, as_listed(unread)) > 0;
}

void remember(WindowSettings& settings, const std::string& opened) {
  const std::string whole = as_listed(opened);
  std::erase(settings.recent, whole);
  settings.recent.insert(settings.recent.begin(), whole);
  if (settings.recent.size() > kMostRecent) settings.recent.resize(kMostRecent);
}

}  // namespace brindle::tool
