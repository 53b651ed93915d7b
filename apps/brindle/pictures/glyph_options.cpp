#include "pictures/glyph_options.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "brindle/legend.h"
#include "brindle/render/parsed_words.h"
#include "cli/command_line.h"
#include "cli/option_fields.h"
#include "pictures/picture_options.h"

namespace brindle::tool {
namespace {

GlyphChoice parse_glyph(const std::string& option, const std::string& text) {
  if (const auto shape = parse_glyph_shape(text)) return {*shape, {}};
  if (lower_extension(text) == ".png") return {GlyphShape::quad, text};
  wrong_usage(option, "disc, arrow, ellipse, stroke or a picture FILE.png", text);
}

std::string parse_size_value(const std::string& option, const std::string& text) {
  check_value_name(option, text);
  return text;
}

ValueRange parse_size_range(const std::string& option, const std::string& text) {
  const ValueRange range = parse_range(option, text);
  if (std::min(range.lowest, range.highest) < 0) {
    wrong_usage(option, "two shares A..B, zero or more", text);
  }
  return range;
}

}  // namespace

void add_glyph_options(CLI::App& app, GlyphOptions& options) {
  add_parsed_option(app, "--glyph", options.glyph, parse_glyph);
  add_field(app, "--glyph-size", options.size);
  add_parsed_option(app, "--size-by", options.size_by, parse_size_value);
  add_parsed_option(app, "--size-range", options.size_range, parse_size_range);
  add_color_options(app, options.style);
}

void check_glyph_options(const CLI::App& command, const GlyphOptions& options) {
  if (options.size_by.empty()) {
    refuse_given(command, {"--size-range"}, "sizes follow no value; add --size-by VALUE");
  }
  if (options.style.color_by.empty()) {
    refuse_given(command, {"--color-range", "--colormap", "--threshold", "--legend", "--no-legend"},
                 "colours follow no value; add --color-by VALUE");
  }
  if (options.style.no_legend) refuse_given(command, {"--legend"}, "--no-legend leaves it out");
  if (!options.glyph.picture.empty()) {
    refuse_given(command, {"--color-by"}, "pictures have colours of their own");
  }
}

std::vector<UsedFile> glyph_files(const GlyphOptions& options) {
  std::vector<UsedFile> files;
  for (const auto& [option, value] :
       {std::pair("--size-by", options.size_by), std::pair("--color-by", options.style.color_by)}) {
    if (const std::string path = value_file(value); !path.empty()) files.push_back({option, path});
  }
  if (!options.glyph.picture.empty()) files.push_back({"--glyph", options.glyph.picture});
  return files;
}

std::optional<Image> read_glyph_picture(const GlyphOptions& options) {
  if (options.glyph.picture.empty()) return std::nullopt;
  return read_png(options.glyph.picture);
}

namespace {

void read_values(const GlyphOptions& options, const ValueSource& source, GlyphInput& input) {
  if (!options.size_by.empty()) {
    input.size = vertex_values("--size-by", options.size_by, source);
    input.size->range("--size-by");
  }
  if (!options.style.color_by.empty()) {
    input.color = vertex_values("--color-by", options.style.color_by, source);
    input.color->range("--color-by");
  }
}

}  // namespace

GlyphInput read_glyph_input(const GlyphOptions& options, const Preparation& prepared,
                            const SurfaceOptions& surface, const WaveOptions& waves,
                            const PictureOptions& picture) {
  Viewpoint viewpoint = seen_viewpoint_of(picture);
  const ValueSource source{prepared.surface,
                           prepared.arrays,
                           surface.mesh,
                           waves.arrays,
                           prepared.vertex_of_row,
                           &viewpoint,
                           prepared.support.coherence};
  GlyphInput input;
  read_values(options, source, input);
  const StyleOptions& style = options.style;
  if (!input.color || style.no_legend || !depends_on_camera(style.color_by)) return input;
  // The legend takes space, so that the camera moves back.
  const Legend legend = color_places(style, *input.color).legend;
  viewpoint.width -= legend_width({legend}, viewpoint.width, viewpoint.height);
  read_values(options, source, input);
  return input;
}

}  // namespace brindle::tool
