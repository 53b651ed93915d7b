/// The values of a picture's style, as input and as colours and sizes.
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
  /// Values of other surfaces' colours: one entry each.
  std::vector<std::optional<VertexValues>> others = {};
};

/// Reads one of them: `option` is --width-by and so on, with its VALUE.
using ReadValues = std::function<VertexValues(const std::string& option, const std::string& value)>;

/// Reads the values of the style. Throws what `read` throws, and Error for values without any
/// number.
StyleValues read_style_values(const StyleOptions& style, const ReadValues& read);

/// Reads the values of other surfaces' colours from their own files and shapes, seen from
/// `viewpoint`. Throws as `read_style_values` does.
std::vector<std::optional<VertexValues>> read_other_values(const StyleOptions& style,
                                                           std::span<const Preparation> others,
                                                           const Viewpoint& viewpoint);

/// Positions of values in the colour map, and the legend.
struct ColorPlaces {
  ColorScale scale;
  std::vector<float> places;  ///< one per vertex; NaN: none
  Legend legend;
};

ColorPlaces color_places(const StyleOptions& style, const VertexValues& color);

/// The values of strokes, kept while a picture is drawn.
struct StyleBindings {
  std::vector<float> widths, opacities, places, regions, tile_sizes;
  std::vector<std::vector<float>> other_places = {};  ///< of other surfaces; empty: no colours
  ColorScale scale;
  std::vector<Legend> legends;
};

StyleBindings follow(const StyleOptions& style, const StyleValues& values);

/// Adds the tiles of a picture and their colours to the legend of its regions, if any; `first` is
/// the tile of the smallest values.
void name_tiles(const StyleOptions& style, const TextureTile& first, const RenderOptions& render,
                StyleBindings& followed);

}  // namespace brindle::tool
