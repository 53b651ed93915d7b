/// The file browser, for reading and writing.
#pragma once

#include <array>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "window/base/window_log.h"

namespace brindle::tool {

/// The purpose of a file choice.
struct FileRequest {
  std::string title;                         ///< "Open a mesh"
  std::vector<std::string> extensions = {};  ///< lower case with the dot; empty: all files
  bool save = false;                         ///< a file to write, whose name may be new
  std::string name = {};                     ///< initial name
  std::string verb = "Save";                 ///< of the save button
  /// The reason why a name is rejected, or empty. By default, `extensions` decide.
  std::function<std::string(const std::filesystem::path&)> refusal = {};
  std::function<void(const std::filesystem::path&)> done = {};
};

/// A dialogue of Dear ImGui. It remembers its folder. Files are named by double click, by Enter or
/// by typing a path.
class FileBrowser {
 public:
  explicit FileBrowser(std::filesystem::path folder);

  void ask(FileRequest request);
  bool is_open() const { return request_.has_value(); }
  const std::filesystem::path& folder() const { return folder_; }

  /// Draws the dialogue while one is open, and calls `done` once the user has chosen.
  void draw(WindowLog& log);

 private:
  struct Item {
    std::string name;
    bool is_folder = false;
    std::uintmax_t bytes = 0;
  };

  void enter(const std::filesystem::path& folder);
  void draw_path(WindowLog& log);
  void draw_items(WindowLog& log);
  void draw_buttons(WindowLog& log);
  void choose(const std::string& name);
  void finish(const std::filesystem::path& path);
  void close();
  bool fits(const std::string& name) const;
  std::string refusal(const std::filesystem::path& path) const;

  std::filesystem::path folder_;
  std::vector<Item> items_;
  std::optional<FileRequest> request_;
  bool newly_asked_ = false;
  bool takes_keys_ = false;  // the name is to be typed, again after a problem
  bool show_all_ = false;
  bool confirm_ = false;  // the file is there already
  std::string name_;
  std::string problem_;
};

}  // namespace brindle::tool
