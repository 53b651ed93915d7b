/// Other surfaces of the picture and their styles.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "pictures/other_surface.h"
#include "window/base/live_session.h"
#include "window/dialogs/file_browser.h"

namespace brindle::tool {

/// A list of surfaces, and widgets for the selected one: the values of --with.
class OtherSurfaces {
 public:
  OtherSurfaces(LiveSession& live, FileBrowser& browser, WindowLog& log)
      : live_(live), browser_(browser), log_(log) {}

  /// Draws the list at the end of a line. `given` are the values; `set` replaces them, and an empty
  /// list removes the option.
  using Set = std::function<void(std::vector<std::string>, ValueChange)>;
  void draw_list(const std::vector<std::string>& given, const Set& set);

  /// Draws the style of the selected surface, one row per part, with widgets from `column` on.
  /// Nothing without a selection. `diagonal`: of the first surface.
  void draw_style(const std::vector<std::string>& given, const Set& set, float column,
                  double diagonal);

  /// Whether a colour is being edited.
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
  std::optional<std::string> edit_;  ///< a value being typed
  bool is_held_ = false;
};

}  // namespace brindle::tool
