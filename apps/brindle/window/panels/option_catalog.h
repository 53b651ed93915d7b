/// The options of sessions, in the groups and with the widgets in which a window shows them.
#pragma once

#include <string>
#include <vector>

#include "brindle/option_table.h"
#include "session/session_document.h"

namespace brindle::tool {

/// `percent`: a length as a share of the diagonal, "0.4%", or in the mesh's units.
enum class WidgetKind { flag, choice, number, numbers, percent, text };

struct CatalogOption {
  std::string name;   ///< "stripes"
  std::string words;  ///< "number of stripes"
  std::string help;
  std::string form;  ///< how values are written: "AZIMUTH,ELEVATION"
  WidgetKind kind = WidgetKind::text;
  std::vector<std::string> names;     ///< values that are names: all of a choice, some of a text
  std::vector<std::string> files;     ///< extensions of files that the value may be
  bool repeatable = false;            ///< a value a line
  bool whole = false;                 ///< numbers that are dragged have no fraction
  SliderRange range;                  ///< of numbers and percents; what is typed may go beyond
  std::string standard;               ///< what counts where it is not given; empty: nothing does
  std::vector<std::string> excludes;  ///< options that are left out when this one is given
};

struct OptionGroup {
  std::string title;
  std::vector<CatalogOption> options;
};

/// Whether every word of `search` is part of what the option is called, means or is for, in small
/// or capital letters.
bool is_meant(const CatalogOption& option, const std::string& search);

/// All options of what is shown, each in one group: first those of curves or samples alone.
std::vector<OptionGroup> option_catalog(Shown shown = Shown::stripes);

}  // namespace brindle::tool
