/// How large a picture is to be: in pixels, or in millimetres of paper.
#pragma once

#include "session/session_document.h"

namespace brindle::tool {

struct PrintSize {
  double width = 0, height = 0;
  bool millimetres = false;  ///< else pixels

  bool operator==(const PrintSize&) const = default;
};

/// The same in whole pixels of which `dpi` are an inch; beyond what an `int` holds, its ends.
PictureSize pixels_of(const PrintSize& size, double dpi);

/// The same size in the other unit.
PrintSize in_millimetres(const PrintSize& size, double dpi);
PrintSize in_pixels(const PrintSize& size, double dpi);

/// With this width, or this height, in the proportions of a picture; pixels are whole.
PrintSize of_width(double width, const PrintSize& size, PictureSize proportions);
PrintSize of_height(double height, const PrintSize& size, PictureSize proportions);

}  // namespace brindle::tool
