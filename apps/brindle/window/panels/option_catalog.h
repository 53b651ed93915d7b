/// Options of sessions with the groups and widgets of the window.
#pragma once

#include <string>
#include <vector>

#include "brindle/option_table.h"
#include "session/session_document.h"

namespace brindle::tool {

/// `percent`: a length, relative to the diagonal ("0.4%") or in the mesh's units.
enum class WidgetKind { flag, choice, number, numbers, percent, text };

struct CatalogOption {
  std::string name;   ///< "stripes"
  std::string words;  ///< "number of stripes"
  std::string help;
  std::string form;  ///< syntax of values: "AZIMUTH,ELEVATION"
  WidgetKind kind = WidgetKind::text;
  std::vector<std::string> names;     ///< literal values: all of a choice, some of a text
  bool file = false;                  ///< the value may be a file
  bool repeatable = false;            ///< one value per line
  bool whole = false;                 ///< numbers are integers
  SliderRange range;                  ///< of numbers and percents; typed values may exceed it
  std::string standard;               ///< default value; empty: none
  std::vector<std::string> excludes;  ///< options that are removed when this one is set
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
