/// Picture sizes in pixels or in millimetres on paper.
#pragma once

#include "session/session_document.h"

namespace brindle::tool {

struct PrintSize {
  double width = 0, height = 0;
  bool millimetres = false;  ///< otherwise pixels

  bool operator==(const PrintSize&) const = default;
};

/// The size in whole pixels at `dpi`, clamped to the range of `int`.
PictureSize pixels_of(const PrintSize& size, double dpi);

/// The size in millimetres.
PrintSize in_millimetres(const PrintSize& size, double dpi);
PrintSize in_pixels(const PrintSize& size, double dpi);

/// With this width or height, in a picture's proportions; pixels are whole.
PrintSize of_width(double width, const PrintSize& size, PictureSize proportions);
PrintSize of_height(double height, const PrintSize& size, PictureSize proportions);

}  // namespace brindle::tool
