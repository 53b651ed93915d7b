/// The export dialog: format by file name, size, background.
#pragma once

#include <string>

#include "session/session_export.h"
#include "window/base/background_jobs.h"
#include "window/dialogs/file_browser.h"
#include "window/dialogs/print_size.h"

namespace brindle::tool {

/// A Dear ImGui dialog. `planned_picture` decides what can be written; files are written in the
/// background as by `brindle render`.
class ExportDialog {
 public:
  ExportDialog(LiveSession& live, BackgroundJobs& jobs, FileBrowser& browser, WindowLog& log)
      : live_(live), jobs_(jobs), browser_(browser), log_(log) {}

  /// With an initial name. Other settings are kept.
  void open(const std::string& name);
  bool is_open() const { return is_open_; }

  /// While it is open; draws the file browser, too.
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
  bool takes_keys_ = false;          // keyboard focus for the name
  std::string name_;                 // or a path
  std::filesystem::path confirmed_;  // confirmed to be replaced
  PrintSize size_;
  double dpi_ = 300;
  bool keeps_proportions_ = true;
  bool transparent_ = false;
  bool scaled_widths_ = true;
  // The inputs of `refusal_`.
  struct Asked {
    std::filesystem::path path;
    PictureChanges changes;
    std::uint64_t revision = 0;
    std::string nothing_left = {};  ///< of the shown picture

    bool operator==(const Asked&) const = default;
  };
  Asked asked_;
  std::string refusal_;
};

}  // namespace brindle::tool
