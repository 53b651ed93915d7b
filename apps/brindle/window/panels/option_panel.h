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

/// Every change is a session command; rejected ones change nothing and add a message. Dragging a
/// slider is one undo step.
class OptionPanel {
 public:
  OptionPanel(LiveSession& live, FileBrowser& browser, WindowLog& log);

  /// Draws all groups into the current Dear ImGui window.
  void draw();

  /// Whether a colour is being edited; all its changes are one step.
  bool is_held() const { return is_held_; }

  /// Draws one option beside its label; nothing for an unknown name.
  void draw_option(const std::string& name);

 private:
  void note_session();
  void note_surface();
  void draw_shown();
  void draw_search();
  /// The number of options in the group that match the search.
  std::size_t draw_group(const OptionGroup& group);
  void draw_option(const CatalogOption& option);
  void draw_label(const CatalogOption& option, bool given);
  void draw_menu(const CatalogOption& option, bool given);
  void draw_widget(const CatalogOption& option);
  void draw_flag(const CatalogOption& option);
  void draw_choice(const CatalogOption& option);
  void draw_number(const CatalogOption& option, const std::string& suffix);
  void draw_numbers(const CatalogOption& option);
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

  std::array<std::vector<OptionGroup>, kAllShown.size()> catalogs_;  // of all pictures
  OptionValues given_;                                               // of the shown picture
  std::uint64_t noted_revision_ = 0;                                 // of the session
  bool is_held_ = false;
  OtherSurfaces others_;
  std::string search_;  // search text
  std::string edited_;  // option and value being typed, such as "field 0"
  std::string edit_;    // typed text
  std::shared_ptr<const LiveState> noted_;
  double diagonal_ = 0;              // of the surface's bounding box
  std::vector<std::string> arrays_;  // "array:NAME" of the surface
};

}  // namespace brindle::tool
