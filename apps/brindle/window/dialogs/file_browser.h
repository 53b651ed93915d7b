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

/// A Dear ImGui dialog that remembers its folder. Files are chosen by double click, Enter or a
/// typed path.
class FileBrowser {
 public:
  explicit FileBrowser(std::filesystem::path folder);

  void ask(FileRequest request);
  bool is_open() const { return request_.has_value(); }
  const std::filesystem::path& folder() const { return folder_; }

  /// Draws the dialog while it is open, and calls `done` after a choice.
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
  bool takes_keys_ = false;  // keyboard focus for the name, again after an error
  bool show_all_ = false;
  bool confirm_ = false;  // the file already exists
  std::string name_;
  std::string problem_;
};

}  // namespace brindle::tool
