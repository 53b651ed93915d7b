#include "pictures/style_values.h"

#include <utility>

namespace brindle::tool {
namespace {

/// The range of values whose colours the map has.
ValueRange color_values(const StyleOptions& style, const VertexValues& values) {
  if (style.color_range) return *style.color_range;
  const Eigen::Vector2f range = values.range("--color-by");
  return {range[0], range[1]};
}

ColorScale scale_of(const StyleOptions& style, const ValueRange& range) {
  ColorScale scale{.map = style.map};
  if (style.threshold) {
    const float length = range.highest - range.lowest;
    scale.threshold = length > 0 ? (*style.threshold - range.lowest) / length
                                 : (*style.threshold <= range.lowest ? 0.0f : 2.0f);
  }
  return scale;
}

}  // namespace

ColorPlaces color_places(const StyleOptions& style, const VertexValues& color) {
  const ValueRange range = color_values(style, color);
  ColorPlaces colors{scale_of(style, range), color.values, {}};
  const float length = range.highest - range.lowest;
  for (float& place : colors.places) place = length > 0 ? (place - range.lowest) / length : 0.5f;
  colors.legend = {.title = style.legend.empty() ? color.title : style.legend,
                   .lowest = range.lowest,
                   .highest = range.highest,
                   .scale = colors.scale};
  return colors;
}

namespace {

void follow_widths(const StyleOptions& style, const VertexValues& width, Followed& followed) {
  const WidthRange widths = style.width_range.value_or(WidthRange());
  const Eigen::Vector2f range = width.range("--width-by");
  followed.widths = rescaled(width.values, range[0], range[1], widths.first, widths.last);
  followed.legends.push_back({.title = width.title,
                              .lowest = range[0],
                              .highest = range[1],
                              .widths = Eigen::Vector2f(widths.first, widths.last)});
}

void follow_colors(const StyleOptions& style, const VertexValues& color, Followed& followed) {
  ColorPlaces colors = color_places(style, color);
  followed.scale = colors.scale;
  followed.places = std::move(colors.places);
  Legend& legend = colors.legend;
  // One bar says both where it is the same value over the same range.
  const bool same = !followed.legends.empty() && style.width_by == style.color_by &&
                    followed.legends[0].lowest == legend.lowest &&
                    followed.legends[0].highest == legend.highest;
  if (same) {
    legend.widths = followed.legends[0].widths;
    followed.legends.clear();
  }
  followed.legends.insert(followed.legends.begin(), std::move(legend));
}

std::string number_text(float value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.4g", static_cast<double>(value));
  return text;
}

/// Where tiles by value are all that a title can be for.
bool has_region_legend(const StyleOptions& style) {
  return !style.regions.empty() && style.color_by.empty() && !style.legend.empty();
}

/// From the largest values down. `name_tiles` says which the tiles are.
Legend region_legend(const StyleOptions& style) {
  Legend legend{.title = style.legend};
  const std::vector<RegionChoice>& regions = style.regions;
  for (std::size_t i = regions.size(); i-- > 0;) {
    const std::string from = number_text(regions[i].from);
    const std::string meaning =
        i + 1 == regions.size() ? "from " + from : from + " to " + number_text(regions[i + 1].from);
    legend.tiles.push_back({.tile = regions[i].tile, .meaning = meaning});
  }
  legend.tiles.push_back(
      {.tile = regions.front().tile, .meaning = "below " + number_text(regions.front().from)});
  return legend;
}

}  // namespace

void name_tiles(const StyleOptions& style, const TextureTile& first, const RenderOptions& render,
                Followed& followed) {
  if (followed.legends.empty() || followed.legends.front().tiles.empty()) return;
  Legend& legend = followed.legends.front();
  legend.ground = render.base_color;
  const std::size_t count = style.regions.size();
  for (std::size_t i = 0; i < count; ++i) {
    legend.tiles[count - 1 - i].figure = style.regions[i].color.value_or(render.stripe_color);
  }
  legend.tiles.back().tile = first;
  legend.tiles.back().figure = render.stripe_color;
}

Followed follow(const StyleOptions& style, const StyleValues& input) {
  Followed followed;
  if (input.width) follow_widths(style, *input.width, followed);
  if (input.color) follow_colors(style, *input.color, followed);
  if (input.opacity) {
    const Eigen::Vector2f range = input.opacity->range("--opacity-by");
    const ValueRange shares = style.opacity_range.value_or(ValueRange());
    followed.opacities =
        rescaled(input.opacity->values, range[0], range[1], shares.lowest, shares.highest);
  }
  if (input.region) followed.regions = input.region->values;
  if (input.tile_size) {
    const Eigen::Vector2f range = input.tile_size->range("--tile-size-by");
    const ValueRange shares = style.tile_size_range.value_or(ValueRange{0.25f, 1});
    followed.tile_sizes =
        rescaled(input.tile_size->values, range[0], range[1], shares.lowest, shares.highest);
  }
  if (has_region_legend(style)) followed.legends.push_back(region_legend(style));
  if (!style.legend.empty()) followed.legends.front().title = style.legend;
  if (style.no_legend) followed.legends.clear();
  return followed;
}

StyleValues read_style_values(const StyleOptions& style, const ReadValues& read) {
  const auto read_one = [&](const char* option, const std::string& value) {
    std::optional<VertexValues> values;
    if (!value.empty()) {
      values = read(option, value);
      values->range(option);
    }
    return values;
  };
  StyleValues values;
  if (!style.by_light()) values.width = read_one("--width-by", style.width_by);
  values.color = read_one("--color-by", style.color_by);
  values.opacity = read_one("--opacity-by", style.opacity_by);
  values.region = read_one("--texture-by", style.texture_by);
  values.tile_size = read_one("--tile-size-by", style.tile_size_by);
  return values;
}

}  // namespace brindle::tool
