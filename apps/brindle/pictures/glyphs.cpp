#include "pictures/glyphs.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "brindle/legend.h"
#include "brindle/render/parsed_words.h"
#include "brindle/render/slice_refusal.h"
#include "cli/command_line.h"
#include "cli/option_fields.h"
#include "pictures/picture.h"

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

namespace {

constexpr Color kGlyphColor{0.78f, 0.26f, 0.17f};

// Interpolates a sample's value in its triangle.
float value_at(const Sample& sample, const Mesh& mesh, std::span<const float> values) {
  float value = 0;
  for (int m = 0; m < 3; ++m) {
    value += sample.barycentric[m] * values[mesh.triangles[sample.triangle][m]];
  }
  return value;
}

std::vector<float> values_at(std::span<const Sample> samples, const Mesh& mesh,
                             std::span<const float> values) {
  std::vector<float> result;
  for (const Sample& sample : samples) result.push_back(value_at(sample, mesh, values));
  return result;
}

std::vector<float> size_factors(std::span<const Sample> samples, const Mesh& mesh,
                                const GlyphOptions& options, const GlyphInput& input) {
  if (!input.size) return {};
  const Eigen::Vector2f range = input.size->range("--size-by");
  const ValueRange shares = options.size_range.value_or(ValueRange{0.25f, 1});
  return rescaled(values_at(samples, mesh, input.size->values), range[0], range[1], shares.lowest,
                  shares.highest);
}

/// Reduces one of the two sizes to the picture's proportions.
void keep_proportions(const Image& tile, std::vector<GlyphSize>& sizes) {
  const float wide = static_cast<float>(tile.width), high = static_cast<float>(tile.height);
  for (GlyphSize& size : sizes) {
    const float pixel = std::min(size.along / wide, size.across / high);
    size = {pixel * wide, pixel * high};
  }
}

}  // namespace

GlyphPicture::GlyphPicture(const Surface& surface, std::span<const Sample> samples,
                           const GlyphOptions& options, const GlyphInput& input,
                           const PictureOptions& picture, const Progress& progress) {
  const Mesh& mesh = surface.mesh;
  std::vector<GlyphSize> sizes =
      glyph_sizes(samples, options.size, size_factors(samples, mesh, options, input));
  if (input.picture) keep_proportions(*input.picture, sizes);
  glyphs_ = glyphs_at(samples, options.glyph.shape, sizes, progress);
  glyphs_.mesh.origin = mesh.origin;
  styled.render = render_options(picture, mesh.origin);
  add_colors(samples, mesh, options, input);
  const RenderOptions& render = styled.render;
  styled.right_margin = legend_width(legends, render.width, render.height);
  surfaces.push_back({.mesh = mesh, .normals = surface.normals, .color = render.base_color});
  if (!glyphs_.mesh.triangles.empty()) surfaces.push_back(motifs(options, input));
}

void GlyphPicture::add_colors(std::span<const Sample> samples, const Mesh& mesh,
                              const GlyphOptions& options, const GlyphInput& input) {
  if (!input.color) return;
  const ColorPlaces colors = color_places(options.style, *input.color);
  styled.scale = colors.scale;
  const std::vector<float> of_samples = values_at(samples, mesh, colors.places);
  for (const Index sample : glyphs_.sample_of_vertex) places_.push_back(of_samples[sample]);
  if (!options.style.no_legend) legends.push_back(colors.legend);
}

StyledSurface GlyphPicture::motifs(const GlyphOptions& options, const GlyphInput& input) const {
  const bool brush = options.glyph.shape == GlyphShape::stroke;
  StyledSurface motifs{.mesh = glyphs_.mesh,
                       .normals = glyphs_.normals,
                       .color = brush ? styled.render.stripe_color : kGlyphColor,
                       .color_places = places_,
                       .shading = !brush};
  if (input.picture) {
    motifs.texture = RegionTexture{.waves = &glyphs_.waves, .tiles = {{.tile = *input.picture}}};
    motifs.between = BetweenStrokes::discarded;
  }
  return motifs;
}

void write_glyphs(const std::filesystem::path& path, const Surface& surface,
                  std::span<const Sample> samples, const GlyphOptions& options,
                  const GlyphInput& input, const PictureOptions& picture,
                  const Progress& progress) {
  constexpr double kPlaced = 0.2;
  const GlyphPicture drawn(surface, samples, options, input, picture, progress.part(0, kPlaced));
  check_slice(
      slice_refusal(drawn.surfaces, styled_camera(drawn.surfaces, drawn.styled), "--slice"));
  Image image = render_styled(drawn.surfaces, drawn.styled, progress.part(kPlaced, kDrawn));
  draw_legends(image, drawn.legends);
  write_png(path, image, progress.part(kDrawn, 1), picture.dpi);
}

}  // namespace brindle::tool
