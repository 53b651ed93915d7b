/// The gallery's items in the window.
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

/// Where the window keeps the data of gallery items, so that saved sessions find them again:
/// `brindle/gallery-VERSION` in $XDG_CACHE_HOME or ~/.cache, else among temporary files.
std::filesystem::path gallery_folder();

/// Makes an item's data in a folder of its name below `folder` unless they are there; never a part
/// of them. Returns that folder. Throws Error if it cannot be written.
std::filesystem::path provide_gallery_data(const GalleryItem& item,
                                           const std::filesystem::path& folder);

/// A menu of all pictures that a session can have, and the live controls of the one that is shown.
class GalleryMenu {
 public:
  /// Does `go`, by which `after` takes the place of what is there, unless a user wants to keep
  /// that.
  using Opener = std::function<void(const SessionDocument& after, const std::string& by,
                                    std::function<void()> go)>;

  GalleryMenu(LiveSession& live, BackgroundJobs& jobs, OptionPanel& options, WindowLog& log,
              Opener open)
      : live_(live), jobs_(jobs), options_(options), log_(log), open_(std::move(open)) {}

  /// Items, into the current menu of Dear ImGui.
  void draw_menu();

  /// Controls of the picture that is shown, into the current window; nothing if none is.
  void draw_panel();

  /// Lets tiles flow on if they do. To be called once a turn; returns whether they flow.
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
  std::string mesh_;  // of the picture that is shown
  bool flows_ = false;
  double flowed_at_ = 0;  // seconds of Dear ImGui
};

}  // namespace brindle::tool
