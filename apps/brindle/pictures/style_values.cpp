#include "pictures/style_values.h"

#include <algorithm>
#include <utility>

namespace brindle::tool {
namespace {

/// Values of one name on one or more surfaces, which share a range and a legend.
struct ColoredValues {
  std::string name;
  std::vector<const VertexValues*> of = {};
};

/// That of --color-by first, if given.
std::vector<ColoredValues> colored_values(const StyleOptions& style, const StyleValues& input) {
  std::vector<ColoredValues> all;
  for (const std::string& name : style.color_values()) {
    ColoredValues& values = all.emplace_back(ColoredValues{name});
    if (input.color && name == style.color_by) values.of.push_back(&*input.color);
    for (std::size_t i = 0; i < input.others.size(); ++i) {
      if (style.others[i].color_by == name) values.of.push_back(&*input.others[i]);
    }
  }
  return all;
}

/// The range of the values, used unless one is given.
ValueRange own_range(std::span<const VertexValues* const> values) {
  Eigen::Vector2f range = values.front()->range("--color-by");
  for (const VertexValues* more : values.subspan(1)) {
    const Eigen::Vector2f other = more->range("--color-by");
    range = {std::min(range[0], other[0]), std::max(range[1], other[1])};
  }
  return {range[0], range[1]};
}

std::vector<float> places_of(std::vector<float> values, const ValueRange& range) {
  const float length = range.highest - range.lowest;
  for (float& value : values) value = length > 0 ? (value - range.lowest) / length : 0.5f;
  return values;
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

Legend color_legend(std::string title, const ValueRange& range, const ColorScale& scale) {
  return {
      .title = std::move(title), .lowest = range.lowest, .highest = range.highest, .scale = scale};
}

}  // namespace

ColorPlaces color_places(const StyleOptions& style, const VertexValues& color) {
  const VertexValues* const only = &color;
  const ValueRange range = style.color_range.value_or(own_range({&only, 1}));
  const ColorScale scale = scale_of(style, range);
  return {scale, places_of(color.values, range),
          color_legend(style.legend.empty() ? color.title : style.legend, range, scale)};
}

namespace {

void follow_widths(const StyleOptions& style, const VertexValues& width, StyleBindings& followed) {
  const WidthRange widths = style.width_range.value_or(WidthRange());
  const Eigen::Vector2f range = width.range("--width-by");
  followed.widths = rescaled(width.values, range[0], range[1], widths.first, widths.last);
  followed.legends.push_back({.title = width.title,
                              .lowest = range[0],
                              .highest = range[1],
                              .widths = Eigen::Vector2f(widths.first, widths.last)});
}

/// Combines the legend of the first value with that of widths, if any.
void add_first_legend(const StyleOptions& style, Legend legend, std::vector<Legend>& legends) {
  // One bar shows both for the same value over the same range.
  const bool same = !legends.empty() && style.width_by == style.color_by &&
                    legends[0].lowest == legend.lowest && legends[0].highest == legend.highest;
  if (same) {
    legend.widths = legends[0].widths;
    legends.clear();
  }
  legends.insert(legends.begin(), std::move(legend));
}

/// The title of values of other surfaces; empty if a legend already has it.
std::string title_of(const ColoredValues& values, std::span<const Legend> legends) {
  const std::string& title = values.of.front()->title;
  const bool taken = std::ranges::find(legends, title, &Legend::title) != legends.end();
  return taken ? values.name : title;
}

void follow_colors(const StyleOptions& style, const StyleValues& input, StyleBindings& followed) {
  const std::vector<ColoredValues> colored = colored_values(style, input);
  followed.other_places.resize(input.others.size());
  for (std::size_t k = 0; k < colored.size(); ++k) {
    const ColoredValues& values = colored[k];
    const bool first = k == 0;
    const ValueRange range = style.range_of_colors(values.name).value_or(own_range(values.of));
    // Thresholds are rejected with several values, so that all share one scale.
    const ColorScale scale = scale_of(style, range);
    if (first) followed.scale = scale;
    if (input.color && values.name == style.color_by) {
      followed.places = places_of(input.color->values, range);
    }
    for (std::size_t i = 0; i < input.others.size(); ++i) {
      if (style.others[i].color_by != values.name) continue;
      followed.other_places[i] = places_of(input.others[i]->values, range);
    }
    if (first) {
      const std::string& title = style.legend.empty() ? values.of.front()->title : style.legend;
      add_first_legend(style, color_legend(title, range, scale), followed.legends);
    } else {
      followed.legends.push_back(color_legend(title_of(values, followed.legends), range, scale));
    }
  }
}

std::string number_text(float value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.4g", static_cast<double>(value));
  return text;
}

/// Whether the title can only belong to tiles by value.
bool has_region_legend(const StyleOptions& style) {
  return !style.regions.empty() && style.color_values().empty() && !style.legend.empty();
}

/// From the largest values down. `name_tiles` adds the tiles.
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
                StyleBindings& followed) {
  if (followed.legends.empty() || followed.legends.front().tiles.empty()) return;
  Legend& legend = followed.legends.front();
  legend.ground = render.base_color;
  const std::size_t count = style.regions.size();
  for (std::size_t i = 0; i < count; ++i) {
    legend.tiles[count - 1 - i].motif = style.regions[i].color.value_or(render.stripe_color);
  }
  legend.tiles.back().tile = first;
  legend.tiles.back().motif = render.stripe_color;
}

StyleBindings follow(const StyleOptions& style, const StyleValues& input) {
  StyleBindings followed;
  if (input.width) follow_widths(style, *input.width, followed);
  follow_colors(style, input, followed);
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

std::vector<std::optional<VertexValues>> read_other_values(const StyleOptions& style,
                                                           std::span<const Preparation> others,
                                                           const Viewpoint& viewpoint) {
  const char* const option = "--with @color-by";
  const ArrayOptions of_own_file;
  std::vector<std::optional<VertexValues>> all(others.size());
  for (std::size_t i = 0; i < others.size(); ++i) {
    const OtherSurfaceChoice& choice = style.others[i];
    if (choice.color_by.empty()) continue;
    const ValueSource source{others[i].surface, others[i].arrays,        choice.mesh,
                             of_own_file,       others[i].vertex_of_row, &viewpoint};
    all[i] = vertex_values(option, choice.color_by, source);
    all[i]->range(option);
  }
  return all;
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
