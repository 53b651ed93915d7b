#include "brindle/render/surfaces/tiled_picture.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>

#include "brindle/error.h"
#include "brindle/gl/gl_buffer.h"
#include "brindle/render/surface_light.h"

namespace brindle {

Eigen::Vector4f tile_transform(const Tile& tile, const RenderOptions& options) {
  const auto scale_x = static_cast<float>(options.width) / static_cast<float>(tile.width);
  const auto scale_y = static_cast<float>(options.height) / static_cast<float>(tile.height);
  const auto middle_x =
      static_cast<float>(2 * tile.x + tile.width) / static_cast<float>(options.width) - 1;
  const auto middle_y =
      static_cast<float>(2 * tile.y + tile.height) / static_cast<float>(options.height) - 1;
  return {scale_x, scale_y, -middle_x * scale_x, -middle_y * scale_y};
}

void set_light(const ShaderProgram& program, const Camera& camera, const RenderOptions& options) {
  const Lights lights = lights_of(camera, {options.camera.up, options.light_from});
  program.set("light_is_moved", options.light_from.has_value());
  program.set("key_from", lights.key);
  program.set("fill_from", lights.fill);
  program.set("up", lights.sky);
}

void set_looks(const ShaderProgram& surface, const RenderOptions& options) {
  surface.set("shading", options.shading);
  surface.set("base_color", linear_light(options.base_color));
  surface.set("stripe_color", linear_light(options.stripe_color));
  surface.set("stripe_width", options.stripe_width);
}

int shading_side(const RenderOptions& options) {
  return options.quality == PictureQuality::interactive ? 1 : options.supersampling;
}

namespace {

/// The largest tile, in finished pixels: as wide as the picture if possible.
Eigen::Vector2i largest_tile(const RenderOptions& options) {
  // Two samples along the side of each evaluation (VisibleTriangles).
  const int longest = std::min(gl_limit(GL_MAX_TEXTURE_SIZE), gl_limit(GL_MAX_VIEWPORT_DIMS)) / 2;
  const int s = shading_side(options);
  const int width = std::min(options.width, std::min(4 * options.tile_side, longest) / s);
  const std::int64_t area = std::int64_t{options.tile_side} * options.tile_side;
  const auto height = static_cast<int>(std::min<std::int64_t>(area / (s * s * width), longest / s));
  return {width, std::min(height, options.height)};
}

}  // namespace

bool is_one_tile(const RenderOptions& options) {
  return largest_tile(options) == Eigen::Vector2i(options.width, options.height);
}

/// One per side length, as a constant: software renderers run one iteration more of loops with
/// variable bounds.
const ShaderProgram& TiledPicture::develop_program(int side) {
  std::optional<ShaderProgram>& program = develop_[static_cast<std::size_t>(side - 1)];
  if (!program) {
    const std::string constant = "const int kShadingSide = " + std::to_string(side) + ";\n";
    program.emplace(ShaderSources{"full_screen.vert"},
                    ShaderSources{{"shading side", constant}, "develop.frag"});
  }
  return *program;
}

void TiledPicture::develop(const Tile& tile, const RenderOptions& options) {
  const ShaderProgram& program = develop_program(shading_side(options));
  program.set("light", 0);
  program.set("tile_corner", Eigen::Vector2i(tile.x, tile.y));
  program.set("picture_size", Eigen::Vector2f(options.width, options.height));
  program.set("background_center", linear_light(options.background_center));
  program.set("background_edge", linear_light(options.background_edge));
  program.set("transparent", options.transparent);
  glBindTextureUnit(0, light_.textures[0]);
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, finished_.framebuffer);
  glViewport(0, 0, tile.width, tile.height);
  fill_viewport(program, no_attributes_);
}

Image TiledPicture::draw(const RenderOptions& options, const DrawLight& draw_light,
                         const Progress& progress) {
  const int s = shading_side(options);
  const Eigen::Vector2i step = largest_tile(options);
  fit_target(light_, {GL_RGBA16F}, false, step.x() * s, step.y() * s);
  fit_target(finished_, {GL_RGBA8}, false, step.x(), step.y());
  Image image(options.width, options.height);
  glPixelStorei(GL_PACK_ROW_LENGTH, options.width);
  for (int y = 0; y < options.height; y += step.y()) {
    for (int x = 0; x < options.width; x += step.x()) {
      const Tile tile{x, y, std::min(step.x(), options.width - x),
                      std::min(step.y(), options.height - y)};
      progress.report("drawing", static_cast<double>(y) / options.height);
      glBindFramebuffer(GL_DRAW_FRAMEBUFFER, light_.framebuffer);
      glViewport(0, 0, tile.width * s, tile.height * s);
      draw_light(light_, tile);
      develop(tile, options);
      glBindFramebuffer(GL_READ_FRAMEBUFFER, finished_.framebuffer);
      glReadPixels(0, 0, tile.width, tile.height, GL_RGBA, GL_UNSIGNED_BYTE, &image.at(x, y));
    }
  }
  glPixelStorei(GL_PACK_ROW_LENGTH, 0);
  check_gl("drawing the picture");
  flip_rows(image.pixels, image.width, image.height);
  return image;
}

void check_options(const RenderOptions& options) {
  check_image_size(options.width, options.height);
  if (!(options.stripe_width >= 0 && options.stripe_width <= 1)) {
    throw Error("a stripe width of " + std::to_string(options.stripe_width) +
                " is no share of the period; give a number from 0 to 1");
  }
  if (options.supersampling < 1 || options.supersampling > 4) {
    throw Error("supersampling of " + std::to_string(options.supersampling) +
                " is out of range; give a number from 1 to 4");
  }
  if (options.tile_side < 64) throw Error("tiles must be at least 64 samples wide");
  if (options.light_from && !(std::isfinite(options.light_from->azimuth_deg) &&
                              std::isfinite(options.light_from->elevation_deg))) {
    throw Error("the light must come from finite angles");
  }
  if (const auto& slice = options.camera.slice) {
    if (!slice->point.allFinite() || !slice->normal.allFinite() || slice->normal.isZero(0)) {
      throw Error("a slice needs a finite point and a finite normal that is not zero");
    }
  }
  if (options.mark_radius && !(*options.mark_radius > 0))
    throw Error("the radius of marks must be above 0 pixels");
}

}  // namespace brindle
