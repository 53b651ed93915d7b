#include "glyph_options.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "brindle/legend.h"
#include "command_line.h"
#include "option_values.h"
#include "picture_options.h"

namespace brindle::tool {
namespace {

constexpr Color kGlyphColor{0.78f, 0.26f, 0.17f};

const std::vector<std::string> kGlyphOptions = {
    "--glyph",       "--glyph-size", "--size-by",   "--size-range", "--color-by",
    "--color-range", "--colormap",   "--threshold", "--legend",     "--no-legend"};

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
  const std::vector<std::string> parts = split(text, ',');
  if (parts.size() != 2) wrong_usage(option, "two shares A,B", text);
  return {parse_not_negative_number(option, parts[0]), parse_not_negative_number(option, parts[1])};
}

// A sample's number from those of its triangle's corners.
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

}  // namespace

void add_glyph_options(CLI::App& app, GlyphOptions& options) {
  add_parsed_option(app, "--glyph", options.glyph, parse_glyph,
                    "picture: what stands at samples: discs (default), arrows along the field, "
                    "ellipses whose axes are the spacings, strokes of a brush, or a picture with "
                    "transparency, which lies flat and may cross the silhouette")
      ->type_name("disc|arrow|ellipse|stroke|FILE.png");
  add_parsed_option(app, "--glyph-size", options.size, parse_positive_number,
                    "picture: share of the spacing (default 0.8)")
      ->type_name("S");
  add_parsed_option(app, "--size-by", options.size_by, parse_size_value,
                    std::string("picture: larger glyphs where a value is larger: ") + kValueNames)
      ->type_name("VALUE");
  add_parsed_option(app, "--size-range", options.size_range, parse_size_range,
                    "--size-by: shares of --glyph-size at the smallest value and the largest "
                    "(default 0.25,1)")
      ->type_name("A,B");
  add_color_options(app, options.style);
}

bool has_glyphs(const CLI::App& command) {
  return std::ranges::any_of(kGlyphOptions, [&](const std::string& option) {
    return command.get_option_no_throw(option) != nullptr && is_given(command, option);
  });
}

void refuse_glyph_options(const CLI::App& command, std::string_view why) {
  refuse_given(command, kGlyphOptions, why);
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

/// Makes one of the two sizes smaller.
void keep_proportions(const Image& tile, std::vector<GlyphSize>& sizes) {
  const float wide = static_cast<float>(tile.width), high = static_cast<float>(tile.height);
  for (GlyphSize& size : sizes) {
    const float pixel = std::min(size.along / wide, size.across / high);
    size = {pixel * wide, pixel * high};
  }
}

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
  Viewpoint viewpoint = viewpoint_of(picture).value();
  const ValueSource source{prepared.surface, prepared.arrays,        surface.mesh,
                           waves.arrays,     prepared.vertex_of_row, &viewpoint};
  GlyphInput input;
  read_values(options, source, input);
  const StyleOptions& style = options.style;
  if (!input.color || style.no_legend || !depends_on_camera(style.color_by)) return input;
  // The legend leaves less room, so that the camera stands farther away.
  const Legend legend = color_places(style, *input.color).legend;
  viewpoint.width -= legend_width({legend}, viewpoint.width, viewpoint.height);
  read_values(options, source, input);
  return input;
}

void write_glyphs(const std::filesystem::path& path, const Surface& surface,
                  std::span<const Sample> samples, const GlyphOptions& options,
                  const GlyphInput& input, const PictureOptions& picture) {
  const Mesh& mesh = surface.mesh;
  std::vector<GlyphSize> sizes =
      glyph_sizes(samples, options.size, size_factors(samples, mesh, options, input));
  if (input.picture) keep_proportions(*input.picture, sizes);
  Glyphs glyphs = glyphs_at(samples, options.glyph.shape, sizes);
  glyphs.mesh.origin = mesh.origin;
  StyledOptions styled;
  styled.render = render_options(picture);
  const bool brush = options.glyph.shape == GlyphShape::stroke;
  StyledSurface figures{.mesh = glyphs.mesh,
                        .normals = glyphs.normals,
                        .color = brush ? styled.render.stripe_color : kGlyphColor,
                        .shading = !brush};
  if (input.picture) {
    figures.texture = RegionTexture{.waves = &glyphs.waves, .tiles = {{.tile = *input.picture}}};
    figures.between = BetweenStrokes::discarded;
  }
  std::vector<float> places;
  std::vector<Legend> legends;
  if (input.color) {
    const ColorPlaces colors = color_places(options.style, *input.color);
    styled.scale = colors.scale;
    const std::vector<float> of_samples = values_at(samples, mesh, colors.places);
    for (const Index sample : glyphs.sample_of_vertex) places.push_back(of_samples[sample]);
    figures.color_places = places;
    if (!options.style.no_legend) legends.push_back(colors.legend);
  }
  styled.right_margin = legend_width(legends, styled.render.width, styled.render.height);
  std::vector<StyledSurface> surfaces{
      {.mesh = mesh, .normals = surface.normals, .color = styled.render.base_color}};
  if (!glyphs.mesh.triangles.empty()) surfaces.push_back(figures);
  Image image = render_styled(surfaces, styled);
  draw_legends(image, legends);
  write_png(path, image);
}

}  // namespace brindle::tool
