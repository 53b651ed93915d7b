/// Settings of the window, kept between starts.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace brindle::tool {

struct WindowSettings {
  std::vector<std::string> recent;  ///< opened meshes and sessions, newest first
  bool dark = true;
  bool show_options = true;
  bool show_metrics = true;
  std::string folder;  ///< last folder of the file browser
};

/// brindle/window.json in $XDG_CONFIG_HOME or ~/.config. Empty without a home folder.
std::filesystem::path settings_path();

/// Reads the settings. Missing or unreadable ones have their defaults.
WindowSettings read_settings(const std::filesystem::path& path);

/// Creates the folder if necessary. Throws what `write_file` throws.
void write_settings(const std::filesystem::path& path, const WindowSettings& settings);

/// Moves an opened file to the front, as an absolute path unless it is a shape.
void remember(WindowSettings& settings, const std::string& opened);

/// Removes an unreadable file from the list. Returns whether it was there.
bool forget(WindowSettings& settings, const std::string& unread);

}  // namespace brindle::tool
