/// The options of sessions, in the groups and with the widgets in which a window shows them.
#pragma once

#include <string>
#include <vector>

#include "session/session_options.h"

namespace brindle::tool {

/// `percent`: a length as a share of the diagonal, "0.4%", or in the mesh's units.
enum class WidgetKind { flag, choice, number, numbers, percent, text };

/// How far a slider reaches; what is typed may go beyond.
struct SliderRange {
  float lowest = 0;
  float highest = 1;
  bool logarithmic = false;  ///< from zero, too
  bool whole = false;
};

struct CatalogOption {
  std::string name;  ///< "stripes"
  std::string help;
  std::string form;  ///< how values are written: "AZIMUTH,ELEVATION"
  WidgetKind kind = WidgetKind::text;
  std::vector<std::string> names;  ///< values that are names: all of a choice, some of a text
  bool file = false;               ///< the value may be a file
  bool repeatable = false;         ///< a value a line
  SliderRange range;               ///< of numbers and percents
  std::string standard;            ///< the value when it is not given, if help names it
};

struct OptionGroup {
  std::string title;
  std::vector<CatalogOption> options;
};

/// All of `options`, each in one group: first those of curves or samples alone, last those that no
/// group names.
std::vector<OptionGroup> option_catalog(const std::vector<SessionOption>& options);

}  // namespace brindle::tool
