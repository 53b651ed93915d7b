/// Legends of pictures without a legend of their own.
#pragma once

#include <string>
#include <vector>

#include "brindle/image.h"
#include "session/live_pattern.h"

namespace brindle::tool {

struct ViewLegend {
  struct Entry {
    Color color;
    std::string meaning;
  };

  std::string title;           ///< empty: none
  std::vector<Entry> entries;  ///< colours with one meaning each
  std::vector<Color> scale;    ///< equal steps from `lowest` to `highest`
  std::string lowest, highest;

  bool empty() const { return entries.empty() && scale.empty(); }
};

/// For --view branches and angle_error, and for curves of two patterns. Empty otherwise: values
/// have legends within the picture, and plain stripes need none.
ViewLegend view_legend(const LiveState& state);

}  // namespace brindle::tool
