/// The values that a picture's style follows, and what they become.
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "brindle/legend.h"
#include "input/preparation.h"
#include "input/vertex_values.h"
#include "pictures/style_options.h"

namespace brindle::tool {

/// One number per vertex each.
struct StyleValues {
  std::optional<VertexValues> width, color, opacity, region, tile_size;
  /// What colours of other surfaces follow: one entry each.
  std::vector<std::optional<VertexValues>> others = {};
};

/// Reads one of them: `option` says --width-by VALUE, and so on.
using ReadValues = std::function<VertexValues(const std::string& option, const std::string& value)>;

/// Reads those that the style names. Throws what `read` does, and Error for values none of which is
/// a number.
StyleValues read_style_values(const StyleOptions& style, const ReadValues& read);

/// Reads what the colours of other surfaces follow: of their own files and shapes, seen from
/// `viewpoint`. Throws as `read_style_values` does.
std::vector<std::optional<VertexValues>> read_other_values(const StyleOptions& style,
                                                           std::span<const Preparation> others,
                                                           const Viewpoint& viewpoint);

/// Where values lie in the colour map, and the legend that says so.
struct ColorPlaces {
  ColorScale scale;
  std::vector<float> places;  ///< one per vertex; NaN: none
  Legend legend;
};

ColorPlaces color_places(const StyleOptions& style, const VertexValues& color);

/// What strokes follow, kept as long as a picture is drawn.
struct StyleBindings {
  std::vector<float> widths, opacities, places, regions, tile_sizes;
  std::vector<std::vector<float>> other_places = {};  ///< of other surfaces; empty: no colours
  ColorScale scale;
  std::vector<Legend> legends;
};

StyleBindings follow(const StyleOptions& style, const StyleValues& values);

/// Puts the tiles of a picture and their colours into the legend of its regions, if it has one:
/// `first` is the tile of the smallest values.
void name_tiles(const StyleOptions& style, const TextureTile& first, const RenderOptions& render,
                StyleBindings& followed);

}  // namespace brindle::tool
