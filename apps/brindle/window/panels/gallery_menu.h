/// The gallery in the window.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <utility>

#include "gallery/gallery.h"
#include "window/base/background_jobs.h"
#include "window/base/live_session.h"
#include "window/panels/option_panel.h"

namespace brindle::tool {

/// The folder of gallery data, permanent so that saved sessions find them:
/// `brindle/gallery-VERSION` in $XDG_CACHE_HOME or ~/.cache, else in the folder of temporary files.
std::filesystem::path gallery_folder();

/// Makes an item's data in a folder of its name below `folder`, atomically, unless it exists.
/// Returns that folder. Throws Error if it cannot be written.
std::filesystem::path provide_gallery_data(const GalleryItem& item,
                                           const std::filesystem::path& folder);

/// A menu of all gallery pictures for sessions, and live controls of the shown one.
class GalleryMenu {
 public:
  /// Calls `go` to replace the document by `after`, unless the user wants to keep the present one.
  using Opener = std::function<void(const SessionDocument& after, const std::string& by,
                                    std::function<void()> go)>;

  GalleryMenu(LiveSession& live, BackgroundJobs& jobs, OptionPanel& options, WindowLog& log,
              Opener open)
      : live_(live), jobs_(jobs), options_(options), log_(log), open_(std::move(open)) {}

  /// Draws the items into the current Dear ImGui menu.
  void draw_menu();

  /// Draws controls of the shown picture into the current window, if there is one.
  void draw_panel();

  /// Advances flowing tiles. Call it once per frame; returns whether tiles flow.
  bool update();

 private:
  void show(const GalleryItem& item, const GalleryPicture& picture);
  void load(const std::string& name, const GalleryPicture& picture,
            const std::filesystem::path& data);
  void take(const std::string& name, const GalleryPicture& picture,
            const SessionDocument& document);
  void draw_steps();
  void draw_flow();

  LiveSession& live_;
  BackgroundJobs& jobs_;
  OptionPanel& options_;
  WindowLog& log_;
  Opener open_;
  const GalleryPicture* shown_ = nullptr;
  std::string title_;
  std::string mesh_;  // of the shown picture
  bool flows_ = false;
  double flowed_at_ = 0;  // in seconds of Dear ImGui
};

}  // namespace brindle::tool
