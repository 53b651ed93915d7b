#include "pictures/styled_output.h"

#include <algorithm>
#include <utility>

#include "brindle/line_drawing.h"
#include "brindle/render/slice_refusal.h"
#include "brindle/stripe_outlines.h"
#include "pictures/drawing_file.h"
#include "pictures/picture.h"

namespace brindle::tool {
namespace {

/// Outlines and creases, as wide as in pictures, with visibility at twice the resolution unless
/// that is too large.
std::vector<Pen> pens_on_top(const StyledPicture& picture, StyleOptions style,
                             const Progress& progress) {
  constexpr int kLargest = 8192;
  StyledOptions options = picture.options;
  RenderOptions& render = options.render;
  const int finer = 2 * std::max(render.width, render.height) <= kLargest ? 2 : 1;
  style.line_width = static_cast<float>(finer) * line_width_of(style, render.height);
  render.width *= finer;
  render.height *= finer;
  options.right_margin *= finer;
  return pens_of_lines(picture.scene, picture.surfaces, style, options,
                       1 / static_cast<float>(finer), progress);
}

/// Outlines of strokes, then lines over them.
void write_outlines(const std::filesystem::path& path, const StyledPicture& picture,
                    const StyleOptions& style, const std::optional<PaperSize>& paper,
                    const Progress& progress) {
  constexpr double kTraced = 0.7, kLined = 0.9;
  const RenderOptions& render = picture.options.render;
  std::vector<Pen> pens =
      stripe_outlines(picture.surfaces, styled_camera(picture.surfaces, picture.options),
                      {render.camera.up, render.light_from}, render.width, render.height,
                      style.min_area, progress.part(0, kTraced));
  for (Pen& pen : pens_on_top(picture, style, progress.part(kTraced, kLined))) {
    if (!pen.strokes.empty()) pens.push_back(std::move(pen));
  }
  write_drawing(path, render.width, render.height, pens, paper, progress.part(kLined, 1));
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
                              std::span<const float> coherence) {
  Viewpoint viewpoint = seen_viewpoint_of(picture);
  if (style.follows_camera()) viewpoint.framed = framed_mesh(prepared.surface.mesh, others);
  const ValueSource source{prepared.surface,       prepared.arrays, surface.mesh, waves.arrays,
                           prepared.vertex_of_row, &viewpoint,      coherence};
  const auto read = [&](const std::string& option, const std::string& value) {
    return vertex_values(option, value, source);
  };
  StyleValues values = read_style_values(style, read);
  values.others = read_other_values(style, others, viewpoint);
  if (!style.follows_camera()) return values;
  // The legend takes space, so that the camera moves back.
  viewpoint.width -= legend_width(follow(style, values).legends, viewpoint.width, viewpoint.height);
  StyleValues seen = read_style_values(style, read);
  seen.others = std::move(values.others);
  return seen;
}

StyleInput read_style_input(const StyleOptions& style, const Preparation& prepared,
                            const WaveSet& drawn, const SurfaceOptions& surface,
                            const WaveOptions& waves, const PictureOptions& picture,
                            JobListener& listener) {
  StyleInput input;
  input.others = read_style_others(style, prepared.surface.mesh, drawn, waves, picture, listener);
  input.values = read_style_values(style, prepared, input.others, surface, waves, picture,
                                   prepared.support.coherence);
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
    styled.broken = left_out_tiles(surface.mesh.triangles, *styled.scene.texture, style,
                                   styled.followed, texture->whole);
    styled.scene.texture->broken = styled.broken;
  }
  styled.options = styled_options(style, picture, surface.mesh.origin, styled.followed);
  if (const Texture* texture = result.texture()) {
    name_tiles(style, texture->tile, styled.options.render, styled.followed);
  }
  styled.surfaces = surfaces_of(styled.scene, style, styled.options.render, styled.followed);
  return styled;
}

void draw_on_top(Image& image, const StyledPicture& picture, const StyleOptions& style,
                 const StyledOptions& drawn, const Progress& progress) {
  draw_lines(image, picture.scene, picture.surfaces, style, drawn, progress);
  draw_legends(image, picture.followed.legends);
}

void write_styled_picture(const std::filesystem::path& path, const Surface& surface,
                          const StripeResult& result, const StylePatterns& patterns,
                          const StyleOptions& style, const StyleInput& input,
                          const PictureOptions& picture, const Progress& progress) {
  StyledPicture styled = styled_picture(surface, result, patterns, style, input, picture);
  check_slice(
      slice_refusal(styled.surfaces, styled_camera(styled.surfaces, styled.options), "--slice"));
  if (is_drawing_file(path)) {
    return write_outlines(path, styled, style, picture.paper, progress);
  }
  constexpr double kPainted = 0.5;
  Image image = render_styled(styled.surfaces, styled.options, progress.part(0, kPainted));
  draw_on_top(image, styled, style, styled.options, progress.part(kPainted, kDrawn));
  write_png(path, image, progress.part(kDrawn, 1), picture.dpi);
}

}  // namespace brindle::tool
