/// The look of strokes and surfaces in pictures.
#pragma once

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "brindle/styled_picture.h"
#include "input/used_files.h"
#include "input/vertex_values.h"
#include "pictures/other_surface.h"

namespace brindle::tool {

/// Widths at the smallest and largest value.
struct WidthRange {
  float first = 0.1f;
  float last = 0.9f;
  WidthUnit unit = WidthUnit::period;
};

/// Silhouettes: none, solid, or dashed where the pattern has strokes.
enum class OutlineStyle { none, solid, dashed };

/// A tile, from a value on.
struct RegionChoice {
  float from = 0;
  BuiltInTile tile = BuiltInTile::dots;
  std::optional<Color> color;
};

/// The part that is coloured by a value.
enum class ColoredPart {
  strokes,
  surface,  ///< also between strokes, and around motifs of tiles
  motifs    ///< of tiles
};

/// The marks of a pattern.
enum class Drawn {
  stripes,
  motifs,   ///< tiles, at least some of which have single-coloured motifs
  pictures  ///< tiles that are picture files
};

struct StyleOptions {
  std::string width_by;  ///< a value, or "light"
  std::optional<WidthRange> width_range;
  std::string color_by;
  std::optional<ValueRange> color_range;
  std::string opacity_by;
  std::optional<ValueRange> opacity_range;
  ColorMap map = ColorMap::viridis;
  std::optional<float> threshold;       ///< a value
  std::optional<ColoredPart> color_on;  ///< empty: strokes, or the surface with tiles
  std::optional<float> pixel_width;
  std::optional<float> spacing;      ///< pixels
  std::optional<float> cross_hatch;  ///< a tone
  std::optional<ValueRange> tones;   ///< lowest: full strokes; highest: none
  bool discard = false;              ///< nothing is drawn between the strokes
  std::vector<OtherSurfaceChoice> others;
  std::string legend;  ///< title; empty: the value's name
  bool no_legend = false;
  bool flat = false;  ///< no light
  bool transparent = false;
  DepthCue depth_cue = DepthCue::none;
  OutlineStyle outline = OutlineStyle::none;
  std::optional<float> crease_deg;  ///< angle from which edges are drawn, with borders
  bool hidden_dashed = false;       ///< instead of leaving hidden lines out
  std::optional<float> line_width;  ///< of outlines and creases, pixels
  float min_area = 0.1f;            ///< of stripe outlines in drawings, square pixels

  float occlusion = 0;
  bool ground_shadow = false;
  std::string texture_by;  ///< value that selects the tile
  std::vector<RegionChoice> regions;
  std::string tile_size_by;                   ///< value of tile sizes
  std::optional<ValueRange> tile_size_range;  ///< shares of their cells
  Eigen::Vector2f texture_shift{0, 0};        ///< in tiles
  Eigen::Vector2f texture_flow{0, 0};         ///< in tiles per second, in moving pictures

  bool has_lines() const {
    return outline != OutlineStyle::none || crease_deg.has_value() ||
           std::ranges::any_of(others, &OtherSurfaceChoice::outlined);
  }
  /// The values of colours, each once: that of the first surface, then those of others.
  std::vector<std::string> color_values() const;
  /// The range that is given for a value's colours.
  std::optional<ValueRange> range_of_colors(const std::string& value) const;
  bool by_light() const { return width_by == "light"; }
  /// The names of all values that the style depends on, or empty.
  std::array<std::string, 5> values() const {
    return {width_by, color_by, opacity_by, texture_by, tile_size_by};
  }
  /// Whether a value or a width depends on the light.
  bool follows_light() const { return std::ranges::any_of(values(), depends_on_light); }

  /// Calls `add("--option", field)` for each option that sets a field.
  template <class Add>
  void visit(const Add& add) {
    add("--color-on", color_on);
    add("--pixel-width", pixel_width);
    add("--stroke-spacing", spacing);
    add("--cross-hatch", cross_hatch);
    add("--outline", outline);
    add("--creases", crease_deg);
    add("--line-width", line_width);
    add("--occlusion", occlusion);
    add("--ground-shadow", ground_shadow);
    add("--flat", flat);
    add("--transparent", transparent);
    add("--depth-cue", depth_cue);
  }
  /// The same for colours by value, which glyphs have, too.
  template <class Add>
  void visit_colors(const Add& add) {
    add("--threshold", threshold);
    add("--legend", legend);
    add("--no-legend", no_legend);
  }

  /// Whether a value depends on the viewpoint.
  bool follows_camera() const;
  bool follows_field() const;  ///< whether a value depends on the field
};

void add_style_options(CLI::App& app, StyleOptions& options);

/// --texture-flow, of moving pictures.
void add_flow_option(CLI::App& app, StyleOptions& options);

/// Whether any option of a style was given; for samples, of glyphs.
bool is_styled(const CLI::App& command);

/// Throws CLI::ValidationError for given style options; `why` is the reason that they have no
/// effect.
void refuse_style_options(const CLI::App& command, std::string_view why);

/// Throws CLI::ValidationError for options without effect beside others.
void check_style_options(const CLI::App& command, const StyleOptions& options, Drawn drawn);

/// The same for drawings of outlines, which have one colour each.
void refuse_for_outlines(const CLI::App& command, const StyleOptions& options);

/// --color-by, --color-range, --colormap, --threshold, --legend and --no-legend.
void add_color_options(CLI::App& app, StyleOptions& options);

/// Input files of values and other surfaces.
std::vector<UsedFile> style_files(const StyleOptions& options);

}  // namespace brindle::tool
