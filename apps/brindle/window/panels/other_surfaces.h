/// Other surfaces of the picture, and what each looks like.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "pictures/other_surface.h"
#include "window/base/live_session.h"
#include "window/dialogs/file_browser.h"

namespace brindle::tool {

/// A list of them, and widgets for the one that is chosen: the values of --with.
class OtherSurfaces {
 public:
  OtherSurfaces(LiveSession& live, FileBrowser& browser, WindowLog& log)
      : live_(live), browser_(browser), log_(log) {}

  /// The list, at the end of a line. `given` are the values; `set` takes others, none to leave the
  /// option out.
  using Set = std::function<void(std::vector<std::string>, ValueChange)>;
  void draw_list(const std::vector<std::string>& given, const Set& set);

  /// What the chosen one looks like, line by line, with widgets from this place on. Nothing if
  /// there is none. `diagonal`: of the first surface.
  void draw_style(const std::vector<std::string>& given, const Set& set, float column,
                  double diagonal);

  /// Whether a colour is being changed.
  bool is_held() const { return is_held_; }

 private:
  using Changed = std::function<void(const OtherSurfaceChoice&, ValueChange)>;
  void draw_choice(OtherSurfaceChoice choice, const Changed& changed, float column,
                   double diagonal);
  void draw_kind(OtherSurfaceChoice& choice, const Changed& changed);
  void draw_colors(OtherSurfaceChoice& choice, const Changed& changed);
  void draw_tile(OtherSurfaceChoice& choice, const Changed& changed);
  void draw_value(OtherSurfaceChoice& choice, const Changed& changed);
  void draw_value_names(const OtherSurfaceChoice& choice, const Changed& changed);
  void draw_stripes(OtherSurfaceChoice& choice, const Changed& changed, float column);
  void draw_place(OtherSurfaceChoice& choice, const Changed& changed, double diagonal);
  void draw_boxes(OtherSurfaceChoice& choice, const Changed& changed);

  LiveSession& live_;
  FileBrowser& browser_;
  WindowLog& log_;
  std::size_t chosen_ = 0;
  std::optional<std::string> edit_;  ///< a value that is being typed
  bool is_held_ = false;
};

}  // namespace brindle::tool
