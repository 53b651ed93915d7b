#include "pictures/styled_output.h"

#include <utility>

#include "brindle/base/file_extension.h"
#include "brindle/line_drawing.h"
#include "brindle/region_outlines.h"
#include "pictures/picture_options.h"

namespace brindle::tool {
namespace {

constexpr float kOutlineScale = 2;  // drawings are traced in pictures so much larger

/// A pen that fills what is white in a picture where all else is black.
Pen traced(std::string name, const Color& color, std::span<const StyledSurface> surfaces,
           const StyledOptions& options) {
  const Image image = render_styled(surfaces, options);
  std::vector<Stroke> loops = region_outlines(image.width, image.height, light_shares(image));
  for (Stroke& loop : loops) {
    for (Eigen::Vector2f& point : loop) point /= kOutlineScale;
  }
  return {std::move(name), color, 1, std::move(loops), true};
}

/// All surfaces in black, `white` with its strokes, or its strokes alone, in white.
std::vector<StyledSurface> black_and_white(std::span<const StyledSurface> surfaces,
                                           std::size_t white, bool strokes_alone) {
  constexpr Color kBlack{0, 0, 0}, kWhite{1, 1, 1};
  std::vector<StyledSurface> result;
  for (std::size_t i = 0; i < surfaces.size(); ++i) {
    StyledSurface& surface = result.emplace_back(surfaces[i]);
    surface.shading = false;
    surface.color = i == white && !strokes_alone ? kWhite : kBlack;
    for (Strokes& strokes : surface.strokes) {
      strokes.color = i == white ? kWhite : kBlack;
      if (strokes.unit == WidthUnit::pixels) strokes.width *= kOutlineScale;
      strokes.spacing *= kOutlineScale;
    }
  }
  return result;
}

void write_outlines(const std::filesystem::path& path, const StyledScene& scene,
                    std::vector<StyledSurface> surfaces, const StyleOptions& style,
                    StyledOptions options, const Progress& progress) {
  const int width = options.render.width, height = options.render.height;
  options.render.width *= static_cast<int>(kOutlineScale);
  options.render.height *= static_cast<int>(kOutlineScale);
  options.render.transparent = true;
  options.depth_cue = DepthCue::none;
  options.occlusion = 0;
  options.ground_shadow = false;
  constexpr double kTraced = 0.7, kLined = 0.9;
  std::vector<Pen> pens;
  for (std::size_t i = surfaces.size(); i-- > 0;) {
    const auto done = static_cast<double>(surfaces.size() - 1 - i);
    progress.report(kTraced * done / static_cast<double>(surfaces.size()));
    const StyledSurface& surface = surfaces[i];
    const std::string number = i == 0 ? "" : "_" + std::to_string(i);
    if (surface.between == BetweenStrokes::surface) {
      pens.push_back(
          traced("surface" + number, surface.color, black_and_white(surfaces, i, false), options));
    }
    if (surface.strokes.empty()) continue;
    pens.push_back(traced("stripes" + number, surface.strokes[0].color,
                          black_and_white(surfaces, i, true), options));
  }
  for (Pen& pen : pens_of_lines(scene, surfaces, style, options, 1 / kOutlineScale,
                                progress.part(kTraced, kLined))) {
    if (!pen.strokes.empty()) pens.push_back(std::move(pen));
  }
  write_svg(path, width, height, pens, progress.part(kLined, 1));
}

StyledScene scene_of(const Surface& surface, const StripeResult& result, const StyleOptions& style,
                     const StylePatterns& patterns) {
  const StripePattern& pattern = result.stripes();
  StyledScene scene{
      surface, {pattern.waves, pattern.solution.z}, std::nullopt, *patterns.others, std::nullopt};
  if (patterns.crossing) {
    scene.crossing.emplace(StripesView{patterns.crossing->waves, patterns.crossing->solution.z});
  }
  if (const Texture* texture = result.texture()) {
    scene.texture.emplace(TextureView{texture->pattern.waves, texture->tile, style.texture_shift});
  }
  return scene;
}

}  // namespace

std::vector<Preparation> read_style_others(const StyleOptions& style, const Mesh& mesh,
                                           const WaveSet& drawn, const WaveOptions& waves,
                                           const PictureOptions& picture, JobListener& listener) {
  Viewpoint viewpoint = viewpoint_of(picture).value();
  viewpoint.framed = mesh;
  return read_others(style, waves, mean_frequency(drawn), viewpoint, listener);
}

StyleValues read_style_values(const StyleOptions& style, const Preparation& prepared,
                              std::span<const Preparation> others, const SurfaceOptions& surface,
                              const WaveOptions& waves, const PictureOptions& picture,
                              std::span<const float> agreement) {
  Viewpoint viewpoint = viewpoint_of(picture).value();
  if (style.follows_camera()) viewpoint.framed = framed_mesh(prepared.surface.mesh, others);
  const ValueSource source{prepared.surface,       prepared.arrays, surface.mesh, waves.arrays,
                           prepared.vertex_of_row, &viewpoint,      agreement};
  const auto read = [&](const std::string& option, const std::string& value) {
    return vertex_values(option, value, source);
  };
  StyleValues values = read_style_values(style, read);
  if (!style.follows_camera()) return values;
  // The legend leaves less room, so that the camera stands farther away.
  viewpoint.width -= legend_width(follow(style, values).legends, viewpoint.width, viewpoint.height);
  return read_style_values(style, read);
}

StyleInput read_style_input(const StyleOptions& style, const Preparation& prepared,
                            const WaveSet& drawn, const SurfaceOptions& surface,
                            const WaveOptions& waves, const PictureOptions& picture,
                            JobListener& listener) {
  StyleInput input;
  input.others = read_style_others(style, prepared.surface.mesh, drawn, waves, picture, listener);
  input.values =
      read_style_values(style, prepared, input.others, surface, waves, picture, prepared.agreement);
  return input;
}

std::shared_ptr<const StripePattern> make_crossing(const Surface& surface,
                                                   const StripeResult& result,
                                                   const StyleOptions& style,
                                                   const StripeOptions& solving,
                                                   const Progress& progress) {
  if (!style.cross_hatch) return nullptr;
  StripeOptions options = solving;
  options.last_phases.clear();
  return std::make_shared<const StripePattern>(stripe_pattern(
      surface, waves_across(result.stripes().waves, surface.normals), options, progress));
}

StylePatterns make_style_patterns(const Surface& surface, const StripeResult& result,
                                  const StyleOptions& style, StyleInput& input,
                                  const StripeOptions& solving, const Progress& progress) {
  StripeOptions options = solving;
  options.last_phases.clear();
  return {make_crossing(surface, result, style, solving, progress),
          std::make_shared<const std::vector<OtherSurface>>(
              solve_others(style, std::move(input.others), options, progress))};
}

StyledPicture styled_picture(const Surface& surface, const StripeResult& result,
                             const StylePatterns& patterns, const StyleOptions& style,
                             const StyleInput& input, const PictureOptions& picture) {
  StyledPicture styled(follow(style, input.values), scene_of(surface, result, style, patterns));
  if (const Texture* texture = result.texture()) {
    WholeTiles whole = texture->whole;
    styled.broken = broken_tiles_of(surface.mesh.triangles, *styled.scene.texture, style,
                                    styled.followed, whole);
    styled.scene.texture->broken = styled.broken;
  }
  styled.options = styled_options(style, picture, styled.followed);
  if (const Texture* texture = result.texture()) {
    name_tiles(style, texture->tile, styled.options.render, styled.followed);
  }
  styled.surfaces = surfaces_of(styled.scene, style, styled.options.render, styled.followed);
  return styled;
}

void draw_on_top(Image& image, const StyledPicture& picture, const StyleOptions& style,
                 const Progress& progress) {
  draw_lines(image, picture.scene, picture.surfaces, style, picture.options, progress);
  draw_legends(image, picture.followed.legends);
}

void write_styled_picture(const std::filesystem::path& path, const Surface& surface,
                          const StripeResult& result, const StylePatterns& patterns,
                          const StyleOptions& style, const StyleInput& input,
                          const PictureOptions& picture, const Progress& progress) {
  StyledPicture styled = styled_picture(surface, result, patterns, style, input, picture);
  if (lower_extension(path) == ".svg") {
    return write_outlines(path, styled.scene, std::move(styled.surfaces), style, styled.options,
                          progress);
  }
  constexpr double kPainted = 0.5;
  Image image = render_styled(styled.surfaces, styled.options, progress.part(0, kPainted));
  draw_on_top(image, styled, style, progress.part(kPainted, kDrawn));
  write_png(path, image, progress.part(kDrawn, 1));
}

}  // namespace brindle::tool
