#include "pictures/picture.h"

#include <algorithm>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "brindle/error.h"
#include "brindle/render/parsed_words.h"
#include "brindle/render/slice_refusal.h"
#include "cli/option_fields.h"
#include "pictures/paper.h"

namespace brindle::tool {
namespace {

void set_camera(RenderOptions& render, const std::string& option, const std::string& text) {
  const auto view = parse_camera_view(text, render.camera.up);
  if (!view) {
    wrong_usage(option, kCameraViewForm, text);
  }
  render.camera = *view;
}

void set_light(RenderOptions& render, const std::string& option, const std::string& text) {
  render.light_from = parse_light_direction(text);
  if (!render.light_from) {
    wrong_usage(option, "AZIMUTH,ELEVATION in degrees, elevation from -90 to 90", text);
  }
}

Slice slice_of(const std::string& option, const std::string& text) {
  const auto slice = parse_slice(text);
  if (!slice) {
    wrong_usage(option, "AXIS=PLACE such as x=0.2, z=50% or -z=50%, or X,Y,Z,NX,NY,NZ", text);
  }
  return *slice;
}

void set_colors(RenderOptions& render, const std::string& option, const std::string& text) {
  std::vector<Color> colors;
  for (const std::string& part : split(text, ',')) {
    const auto color = parse_color(part);
    if (!color) wrong_usage(option, "colours like #1c325a, 1c325a or steelblue", text);
    colors.push_back(*color);
  }
  if (colors.size() < 2 || colors.size() > 3) {
    wrong_usage(option, "STRIPE,SURFACE or STRIPE,SURFACE,BACKGROUND", text);
  }
  render.stripe_color = colors[0];
  render.base_color = colors[1];
  if (colors.size() == 3) render.background_center = render.background_edge = colors[2];
}

// An option that changes the rendering options.
template <class Set>
CLI::Option* add_render_option(CLI::App& app, const std::string& name, RenderOptions& render,
                               Set set) {
  return app.add_option_function<std::string>(
      name, [name, &render, set](const std::string& text) { set(render, name, text); });
}

}  // namespace

void add_size_options(CLI::App& app, PictureOptions& options) {
  add_render_option(app, "--size", options.render, set_pixel_size)
      ->description("picture: pixels (default: the session's)")
      ->type_name("WIDTHxHEIGHT");
  add_field(app, "--quality", options.render.quality);
}

void add_camera_options(CLI::App& app, PictureOptions& options) {
  RenderOptions& render = options.render;
  add_render_option(app, "--camera", render, set_camera);
  add_field(app, "--projection", options.projection);
  add_field(app, "--up", options.up);
  add_render_option(app, "--light-from", render, set_light);
  add_parsed_option(app, "--slice", options.slice, slice_of);
  app.add_option_function<std::string>("--size", [&app, &options](const std::string& text) {
    set_size(app, options, "--size", text);
  });
  add_field(app, "--quality", render.quality);
  add_render_option(app, "--colors", render, set_colors);
}

void add_paper_options(CLI::App& app, PictureOptions& options) {
  add_parsed_option(app, "--scale", options.scale, parse_scale);
  add_field(app, "--dpi", options.dpi);
}

void add_picture_options(CLI::App& app, PictureOptions& options) {
  add_camera_options(app, options);
  options.visit_stripes(AddField(app));
}

void stand_upright(PictureOptions& options, const std::string& mesh) {
  if (!options.up) options.up = usual_up_axis(mesh);
}

std::optional<Viewpoint> viewpoint_of(const PictureOptions& options) {
  PictureOptions whole = options;
  whole.slice.reset();
  const RenderOptions render = render_options(whole, Eigen::Vector3d::Zero());
  // A file's pictures have y up only because nobody has said what is; its heights stay along z.
  return Viewpoint{
      render.camera,    render.width, render.height, std::nullopt, options.up.value_or(UpAxis::z),
      render.light_from};
}

Viewpoint seen_viewpoint_of(const PictureOptions& options) {
  Viewpoint viewpoint = viewpoint_of(options).value();
  viewpoint.view.slice = options.slice;
  return viewpoint;
}

bool shows_stripes(const PictureOptions& options) { return options.view == View::stripes; }

nlohmann::ordered_json picture_json(const PictureOptions& options) {
  const bool drafts = options.render.quality == PictureQuality::interactive;
  const UpAxis up = options.up.value_or(options.render.camera.up);
  return {{"picture_quality", drafts ? "interactive" : "final"}, {"picture_up", name_of(up)}};
}

Overlay overlay_of(View view, const Mesh& mesh, const WaveSet& waves,
                   std::span<const CornerPhases> corners) {
  if (view == View::branches) return branch_overlay(mesh, corners);
  if (view == View::angle_error) {
    return error_overlay(angle_errors_deg(mesh, waves, corners), kLargestAngleErrorDeg);
  }
  return {};
}

RenderOptions render_options(const PictureOptions& options, const Eigen::Vector3d& origin) {
  RenderOptions render = options.render;
  render.camera.slice = options.slice;
  if (options.slice && !options.slice->in_shares) render.camera.slice->point -= origin;
  if (options.view != View::stripes) render = with_faint_stripes(render);
  render.camera.up = options.up.value_or(render.camera.up);
  render.camera.projection = options.projection.value_or(render.camera.projection);
  set_paper(render, options);
  return render;
}

SplatDrawing splat_drawing_of(const Surface& surface, const StripePattern& pattern,
                              std::span<const float> radii) {
  return {.positions = surface.mesh.positions,
          .normals = surface.normals,
          .radii = radii,
          .waves = &pattern.waves,
          .z = pattern.solution.z};
}

SurfaceDrawing drawing_of(const Surface& surface, const StripeResult& result,
                          const Overlay& overlay) {
  const StripePattern& pattern = result.stripes();
  SurfaceDrawing drawing{.mesh = surface.mesh,
                         .normals = surface.normals,
                         .waves = &pattern.waves,
                         .z = pattern.solution.z,
                         .triangle_colors = overlay.triangle_colors,
                         .marks = overlay.marks};
  if (const Texture* texture = result.texture()) {
    drawing.texture_waves = &texture->pattern.waves;
    drawing.texture_tile = &texture->tile;
    // The texture caches its broken tiles.
    drawing.broken_tiles = texture->broken(surface.mesh).get();
  }
  return drawing;
}

void write_picture(const std::filesystem::path& path, const Surface& surface,
                   const StripeResult& result, const PictureOptions& options,
                   const Progress& progress) {
  const Progress drawing = progress.part(0, kDrawn), writing = progress.part(kDrawn, 1);
  const StripePattern& pattern = result.stripes();
  const RenderOptions render = render_options(options, surface.mesh.origin);
  check_slice(surface.mesh, render, "--slice");
  if (surface.mesh.triangles.empty()) {
    const std::vector<float> radii = splat_radii(surface.mesh.positions, *surface.neighborhood);
    const SplatDrawing splats = splat_drawing_of(surface, pattern, radii);
    return write_png(path, render_splats(splats, render, drawing), writing, options.dpi);
  }
  const Overlay overlay = overlay_of(options.view, surface.mesh, pattern.waves, pattern.corners);
  const SurfaceDrawing drawn = drawing_of(surface, result, overlay);
  write_png(path, render_picture(drawn, render, drawing), writing, options.dpi);
}

std::string tile_png(const TextureTile& tile, const PictureOptions& options) {
  constexpr int kSide = 512;
  return png_of(tile_picture(tile, kSide, options.render.stripe_color, options.render.base_color));
}

}  // namespace brindle::tool
