#include "window/dialogs/print_size.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "brindle/line_drawing.h"

namespace brindle::tool {
namespace {

int whole_pixels(double pixels) {
  constexpr double kMost = std::numeric_limits<int>::max();
  if (!std::isfinite(pixels)) return 0;
  return static_cast<int>(std::round(std::clamp(pixels, -kMost, kMost)));
}

PrintSize rounded(PrintSize size) {
  if (size.millimetres) return size;
  return {std::round(size.width), std::round(size.height)};
}

double ratio(PictureSize proportions) {
  return static_cast<double>(proportions.height) / proportions.width;
}

}  // namespace

PictureSize pixels_of(const PrintSize& size, double dpi) {
  const double scale = size.millimetres ? dpi / kMillimetresPerInch : 1;
  return {whole_pixels(scale * size.width), whole_pixels(scale * size.height)};
}

PrintSize in_millimetres(const PrintSize& size, double dpi) {
  if (size.millimetres || !(dpi > 0)) return size;
  const double scale = kMillimetresPerInch / dpi;
  return {scale * size.width, scale * size.height, true};
}

PrintSize in_pixels(const PrintSize& size, double dpi) {
  if (!size.millimetres) return size;
  const PictureSize pixels = pixels_of(size, dpi);
  return {static_cast<double>(pixels.width), static_cast<double>(pixels.height)};
}

PrintSize of_width(double width, const PrintSize& size, PictureSize proportions) {
  return rounded({width, width * ratio(proportions), size.millimetres});
}

PrintSize of_height(double height, const PrintSize& size, PictureSize proportions) {
  return rounded({height / ratio(proportions), height, size.millimetres});
}

}  // namespace brindle::tool
