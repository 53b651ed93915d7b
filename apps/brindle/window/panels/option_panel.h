/// The options of the session, as widgets.
#pragma once

#include <array>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "window/base/live_session.h"
#include "window/dialogs/file_browser.h"
#include "window/panels/option_catalog.h"
#include "window/panels/other_surfaces.h"

namespace brindle::tool {

/// Every change is a command of the session; what it refuses stays as it was, and a message says
/// why. Dragging a slider is one step to undo.
class OptionPanel {
 public:
  OptionPanel(LiveSession& live, FileBrowser& browser, WindowLog& log);

  /// All groups, into the current window of Dear ImGui.
  void draw();

  /// Whether a colour is being changed: all that happens to it meanwhile is one step.
  bool is_held() const { return is_held_; }

  /// One option beside its name, or nothing if there is none of that name.
  void draw_option(const std::string& name);

 private:
  void note_session();
  void note_surface();
  void draw_shown();
  void draw_search();
  /// How many options of the group fit the search.
  std::size_t draw_group(const OptionGroup& group);
  void draw_option(const CatalogOption& option);
  void draw_label(const CatalogOption& option, bool given);
  void draw_menu(const CatalogOption& option, bool given);
  void draw_widget(const CatalogOption& option);
  void draw_flag(const CatalogOption& option);
  void draw_choice(const CatalogOption& option);
  void draw_number(const CatalogOption& option, float value, bool known);
  void draw_numbers(const CatalogOption& option);
  void draw_percent(const CatalogOption& option);
  void draw_text(const CatalogOption& option, std::size_t index, float width);
  void draw_texts(const CatalogOption& option);
  void draw_names(const CatalogOption& option, std::size_t index);
  void draw_slice(const CatalogOption& option);
  void draw_colors(const CatalogOption& option);
  void draw_others(const CatalogOption& option, float column);
  std::vector<std::string> values_of(const CatalogOption& option) const;

  std::string text_of(const CatalogOption& option) const;
  SliderRange range_of(const CatalogOption& option) const;
  void set(const CatalogOption& option, std::vector<std::string> values,
           ValueChange change = ValueChange::typed);
  void set_one(const CatalogOption& option, std::size_t index, const std::string& value);

  LiveSession& live_;
  FileBrowser& browser_;
  WindowLog& log_;
  const std::vector<OptionGroup>& catalog() const {
    return catalogs_[static_cast<std::size_t>(live_.document().shown)];
  }

  std::array<std::vector<OptionGroup>, kAllShown.size()> catalogs_;  // of what can be shown
  OptionValues given_;                                               // of what is shown
  std::uint64_t noted_revision_ = 0;                                 // of the session
  bool is_held_ = false;
  OtherSurfaces others_;
  std::string search_;  // what options are looked for by
  std::string edited_;  // option and value that are being typed, such as "field 0"
  std::string edit_;    // what has been typed
  std::shared_ptr<const LiveState> noted_;
  double diagonal_ = 0;              // of the surface's bounding box
  std::vector<std::string> arrays_;  // "array:NAME" of the surface
};

}  // namespace brindle::tool
