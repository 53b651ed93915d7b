/// What a picture's file is to be: its format by its name, its size, its background.
#pragma once

#include <string>

#include "session/session_export.h"
#include "window/base/background_jobs.h"
#include "window/dialogs/file_browser.h"
#include "window/dialogs/print_size.h"

namespace brindle::tool {

/// A dialogue of Dear ImGui. What can be written is decided by `planned_picture`, and it is written
/// as `brindle render` does, in the background.
class ExportDialog {
 public:
  ExportDialog(LiveSession& live, BackgroundJobs& jobs, FileBrowser& browser, WindowLog& log)
      : live_(live), jobs_(jobs), browser_(browser), log_(log) {}

  /// With a name to begin with. All else is as it was left.
  void open(const std::string& name);
  bool is_open() const { return is_open_; }

  /// While it is open; then the browser of files is drawn by it.
  void draw();

 private:
  bool draw_file();
  void draw_size();
  void draw_side(const char* name, double side,
                 PrintSize (*of_side)(double, const PrintSize&, PictureSize));
  void draw_looks();
  void draw_result();
  bool draw_buttons(bool entered);
  void start();

  std::filesystem::path path() const;
  double dpi() const;
  PictureChanges changes() const;
  const std::string& refusal();

  LiveSession& live_;
  BackgroundJobs& jobs_;
  FileBrowser& browser_;
  WindowLog& log_;
  bool is_open_ = false;
  bool newly_opened_ = false;
  bool takes_keys_ = false;          // the name is to be typed
  std::string name_;                 // or a path
  std::filesystem::path confirmed_;  // that may be replaced
  PrintSize size_;
  double dpi_ = 300;
  bool keeps_proportions_ = true;
  bool transparent_ = false;
  bool scaled_widths_ = true;
  // What `refusal_` is about.
  struct Asked {
    std::filesystem::path path;
    PictureChanges changes;
    std::uint64_t revision = 0;
    std::string nothing_left = {};  ///< of the picture that is shown

    bool operator==(const Asked&) const = default;
  };
  Asked asked_;
  std::string refusal_;
};

}  // namespace brindle::tool
