/// What the window remembers from one start to the next.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace brindle::tool {

struct WindowSettings {
  std::vector<std::string> recent;  ///< meshes and sessions as they were opened, the newest first
  bool dark = true;
  bool show_options = true;
  bool show_figures = true;
  std::string folder;  ///< where files were chosen last
};

/// brindle/window.json in $XDG_CONFIG_HOME, or in ~/.config. Empty if there is no home.
std::filesystem::path settings_path();

/// Those of the file. Whatever is missing or cannot be read is as at the first start.
WindowSettings read_settings(const std::filesystem::path& path);

/// Makes the folder if it is not there. Throws what `write_file` does.
void write_settings(const std::filesystem::path& path, const WindowSettings& settings);

/// Puts an opened file first, once, as a whole path unless it is a shape.
void remember(WindowSettings& settings, const std::string& opened);

/// Takes a file that cannot be read off the list. Returns whether it was there.
bool forget(WindowSettings& settings, const std::string& unread);

}  // namespace brindle::tool
