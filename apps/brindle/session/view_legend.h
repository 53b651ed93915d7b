/// What the colours of a picture mean that has no legend of its own.
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
  std::vector<Entry> entries;  ///< colours that mean one thing each
  std::vector<Color> scale;    ///< of numbers, from `lowest` to `highest`, in even steps
  std::string lowest, highest;

  bool empty() const { return entries.empty() && scale.empty(); }
};

/// Of --view branches and angle_error, and of curves of two patterns. Values have legends within
/// the picture, and plain stripes need none: empty.
ViewLegend view_legend(const LiveState& state);

}  // namespace brindle::tool
