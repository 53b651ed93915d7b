/// Options of sessions with the groups and widgets of the window.
#pragma once

#include <string>
#include <vector>

#include "brindle/option_table.h"
#include "session/session_document.h"

namespace brindle::tool {

struct CatalogOption {
  std::string name;   ///< "stripes"
  std::string words;  ///< "number of stripes"
  std::string help;
  std::string form;  ///< syntax of values: "AZIMUTH,ELEVATION"
  OptionKind kind = OptionKind::text;
  std::vector<std::string> names;  ///< values that are names: all of a choice, some of a text
  std::vector<std::string> files;  ///< extensions of files that the value may be
  bool repeatable = false;         ///< a value a line
  bool whole = false;              ///< numbers that are dragged have no fraction
  SliderRange range;     ///< of numbers, and of lengths in per cent; what is typed may go beyond
  std::string standard;  ///< what counts where it is not given; empty: nothing does
  std::vector<std::string> excludes;  ///< options that are left out when this one is given
};

struct OptionGroup {
  std::string title;
  std::vector<CatalogOption> options;
};

/// Whether every word of `search` is in the option's label, name or help, ignoring case.
bool is_meant(const CatalogOption& option, const std::string& search);

/// All options of the shown picture, each in one group; those of curves or samples alone are first.
std::vector<OptionGroup> option_catalog(Shown shown = Shown::stripes);

}  // namespace brindle::tool
