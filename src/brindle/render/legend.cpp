#include "brindle/legend.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "brindle/error.h"
#include "brindle/ink.h"
#include "brindle/render/stroke_font.h"

namespace brindle {
namespace {

using Eigen::Vector2f;

constexpr int kMostTicks = 6;
constexpr float kLabelGap = 0.6f;  // between a bar and its labels, in letters

/// Sizes of a legend, in pixels.
struct LegendSizes {
  float letter;  // height of capitals
  float line;    // width of the pen
  float bar;     // width of the bar
  float margin;
};

LegendSizes sizes_for(int width, int height) {
  const float side = static_cast<float>(std::min(height, 4 * width / 3));
  const float letter = std::max(7.0f, side / 58);
  return {letter, std::max(1.05f, letter / 7.5f), 1.5f * letter, 2.2f * letter};
}

std::string text_of(double value, double step) {
  const double digits = -std::floor(std::log10(step) + 1e-9);
  char text[32];
  const double largest = std::abs(value) + step;
  if (largest >= 1e6 || step < 1e-4) {
    std::snprintf(text, sizeof text, "%.3g", value);
  } else {
    std::snprintf(text, sizeof text, "%.*f", static_cast<int>(std::max(digits, 0.0)), value);
  }
  return text;
}

struct Tick {
  double value;
  std::string text;
};

std::vector<Tick> ticks_of(const Legend& legend) {
  const std::vector<double> values = tick_values(static_cast<double>(legend.lowest),
                                                 static_cast<double>(legend.highest), kMostTicks);
  const double step = values.size() > 1 ? values[1] - values[0] : 1.0;
  std::vector<Tick> ticks;
  for (const double value : values) {
    ticks.push_back({value, text_of(std::abs(value) < 1e-9 * step ? 0.0 : value, step)});
  }
  return ticks;
}

/// Whether values above the threshold are not on the bar: a field above it shows their colour.
bool has_field_beyond(const Legend& legend) {
  constexpr float kRounding = 1e-6f;
  return legend.scale && legend.scale->threshold && legend.highest > legend.lowest &&
         *legend.scale->threshold >= 1 - kRounding;
}

std::string text_beyond(const Legend& legend) {
  char text[32];
  const float from = legend.lowest + *legend.scale->threshold * (legend.highest - legend.lowest);
  std::snprintf(text, sizeof text, "from %.4g", static_cast<double>(from));
  return text;
}

/// The side of a tile in a legend, in pixels.
int tile_side(const LegendSizes& sizes) {
  return static_cast<int>(std::lround(3.2f * sizes.letter));
}

float tiles_width(const Legend& legend, const LegendSizes& sizes) {
  float widest = 0;
  for (const LegendTile& tile : legend.tiles) {
    widest = std::max(widest, text_width(tile.meaning, sizes.letter));
  }
  return static_cast<float>(tile_side(sizes)) + sizes.letter + widest;
}

float label_width(const Legend& legend, const LegendSizes& sizes) {
  float widest = has_field_beyond(legend) ? text_width(text_beyond(legend), sizes.letter) : 0;
  for (const Tick& tick : ticks_of(legend)) {
    widest = std::max(widest, text_width(tick.text, sizes.letter));
  }
  return widest;
}

float width_of(const Legend& legend, const LegendSizes& sizes) {
  const float bar = legend.tiles.empty()
                        ? sizes.bar + kLabelGap * sizes.letter + label_width(legend, sizes)
                        : tiles_width(legend, sizes);
  return std::max(bar, text_width(legend.title, sizes.letter)) + 2 * sizes.margin;
}

/// The bar from the highest value at `top` to the lowest at `bottom`.
void draw_bar(Image& image, const Legend& legend, const Vector2f& top, float bottom, float width) {
  const float height = bottom - top.y();
  const Vector2f widths = legend.widths.value_or(Vector2f(1, 1));
  const float widest = std::max(widths.maxCoeff(), 1e-9f);
  for (float y = top.y(); y < bottom; y = std::floor(y) + 1) {
    const float next = std::min(std::floor(y) + 1, bottom);
    const float place = 1 - (0.5f * (y + next) - top.y()) / height;
    Color color = legend.ink;
    if (legend.scale) {
      const bool beyond = legend.scale->threshold && place >= *legend.scale->threshold;
      color = beyond ? legend.scale->beyond : map_color(legend.scale->map, place);
    }
    const float share = std::max(widths[0] + place * (widths[1] - widths[0]), 0.0f) / widest;
    const float inset = 0.5f * width * (1 - share);
    fill(image, {top.x() + inset, y}, {top.x() + width - inset, next}, color);
  }
}

/// Draws the field at `corner` and its label among `lines`. Returns the offset of the bar below it.
float draw_field_beyond(Image& image, const Legend& legend, const LegendSizes& sizes,
                        const Vector2f& corner, std::vector<Stroke>& lines) {
  const float height = 1.5f * sizes.letter;
  fill(image, corner, corner + Vector2f(sizes.bar, height), legend.scale->beyond);
  const Vector2f label =
      corner + Vector2f(sizes.bar + kLabelGap * sizes.letter, 0.5f * (height + sizes.letter));
  const std::vector<Stroke> letters = text_strokes(text_beyond(legend), label, sizes.letter);
  lines.insert(lines.end(), letters.begin(), letters.end());
  return height + 0.6f * sizes.letter;
}

/// Draws the legend's tiles as a column from `top` on, with their meanings.
void draw_tiles(Image& image, const Legend& legend, const LegendSizes& sizes, const Vector2f& top,
                std::vector<Stroke>& lines) {
  const int side = tile_side(sizes), left = static_cast<int>(std::lround(top.x()));
  int upper = static_cast<int>(std::lround(top.y()));
  for (const LegendTile& tile : legend.tiles) {
    const Image picture = tile_picture(tile.tile, side, tile.motif, legend.ground);
    for (int y = 0; y < std::min(side, image.height - upper); ++y) {
      for (int x = 0; x < std::min(side, image.width - left); ++x) {
        image.at(left + x, upper + y) = picture.at(x, y);
      }
    }
    const Vector2f label(
        static_cast<float>(left + side) + sizes.letter,
        static_cast<float>(upper) + 0.5f * (static_cast<float>(side) + sizes.letter));
    const std::vector<Stroke> letters = text_strokes(tile.meaning, label, sizes.letter);
    lines.insert(lines.end(), letters.begin(), letters.end());
    upper += side + static_cast<int>(std::lround(0.7f * sizes.letter));
  }
}

void draw_legend(Image& image, const Legend& legend, const LegendSizes& sizes, float left,
                 float top, float bottom) {
  std::vector<Stroke> lines = text_strokes(legend.title, {left, top + sizes.letter}, sizes.letter);
  Vector2f bar(left, top + 2.3f * sizes.letter);
  if (!legend.tiles.empty()) {
    draw_tiles(image, legend, sizes, bar, lines);
    return ink(image, lines, sizes.line, legend.ink);
  }
  if (has_field_beyond(legend)) bar.y() += draw_field_beyond(image, legend, sizes, bar, lines);
  draw_bar(image, legend, bar, bottom, sizes.bar);
  const float range = legend.highest - legend.lowest;
  for (const auto& [value, text] : ticks_of(legend)) {
    const float place = range > 0 ? (static_cast<float>(value) - legend.lowest) / range : 0.5f;
    const float y = bottom - place * (bottom - bar.y());
    const float x = bar.x() + sizes.bar + kLabelGap * sizes.letter;
    const auto letters = text_strokes(text, {x, y + 0.5f * sizes.letter}, sizes.letter);
    lines.insert(lines.end(), letters.begin(), letters.end());
  }
  ink(image, lines, sizes.line, legend.ink);
}

}  // namespace

int legend_width(const std::vector<Legend>& legends, int width, int height) {
  float widest = 0;
  for (const Legend& legend : legends) {
    widest = std::max(widest, width_of(legend, sizes_for(width, height)));
  }
  return std::min(static_cast<int>(std::ceil(widest)), width / 2);
}

void draw_legends(Image& image, const std::vector<Legend>& legends) {
  for (const Legend& legend : legends) {
    if (!std::isfinite(legend.lowest) || !std::isfinite(legend.highest)) {
      throw Error("a legend needs two numbers as its ends");
    }
  }
  if (legends.empty()) return;
  const LegendSizes sizes = sizes_for(image.width, image.height);
  const auto height = static_cast<float>(image.height);
  const float left = static_cast<float>(image.width) -
                     static_cast<float>(legend_width(legends, image.width, image.height)) +
                     sizes.margin;
  const float used =
      std::min(height - 2 * sizes.margin, static_cast<float>(legends.size()) * 0.42f * height);
  const float each = used / static_cast<float>(legends.size());
  float top = 0.5f * (height - used);
  for (const Legend& legend : legends) {
    draw_legend(image, legend, sizes, left, top, top + each - 2.0f * sizes.letter);
    top += each;
  }
}

}  // namespace brindle
