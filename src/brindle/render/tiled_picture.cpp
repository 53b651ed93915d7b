#include "brindle/render/tiled_picture.h"

#include <algorithm>
#include <array>
#include <string>

#include "brindle/error.h"
#include "brindle/gl/gl_buffer.h"

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

Eigen::Vector3f up_seen_by(const Camera& camera, UpAxis up) {
  return camera.view_from_world.block<3, 1>(0, up == UpAxis::y ? 1 : 2);
}

void set_looks(const ShaderProgram& surface, const RenderOptions& options) {
  surface.set("shading", options.shading);
  surface.set("base_color", linear_light(options.base_color));
  surface.set("stripe_color", linear_light(options.stripe_color));
  surface.set("stripe_width", options.stripe_width);
}

void TiledPicture::develop(const Target& light, const Target& finished, const Tile& tile,
                           const RenderOptions& options) const {
  develop_.set("light", 0);
  develop_.set("supersampling", options.supersampling);
  develop_.set("tile_corner", Eigen::Vector2i(tile.x, tile.y));
  develop_.set("picture_size", Eigen::Vector2f(options.width, options.height));
  develop_.set("background_center", linear_light(options.background_center));
  develop_.set("background_edge", linear_light(options.background_edge));
  develop_.set("transparent", options.transparent);
  glBindTextureUnit(0, light.textures[0]);
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, finished.framebuffer);
  glViewport(0, 0, tile.width, tile.height);
  glUseProgram(develop_.name());
  glBindVertexArray(no_attributes_);
  glDrawArrays(GL_TRIANGLES, 0, 3);
}

Image TiledPicture::draw(const RenderOptions& options, int samples,
                         const DrawLight& draw_light) const {
  constexpr std::array<float, 4> kNothing{0, 0, 0, 0};
  constexpr float kFarthest = 1;
  const int s = options.supersampling;
  const int side =
      std::min({options.tile_side, gl_limit(GL_MAX_TEXTURE_SIZE), gl_limit(GL_MAX_VIEWPORT_DIMS)});
  // An even number of pixels, so that derivatives pair the same pixels in every tiling.
  const int step = side / s / 2 * 2;
  const int width = std::min(step, options.width), height = std::min(step, options.height);
  const Target many = target_of({GL_RGBA16F}, true, width * s, height * s, samples);
  const Target light = target_of({GL_RGBA16F}, false, width * s, height * s);
  const Target finished = target_of({GL_RGBA8}, false, width, height);
  Image image(options.width, options.height);
  glPixelStorei(GL_PACK_ROW_LENGTH, options.width);
  for (int y = 0; y < options.height; y += step) {
    for (int x = 0; x < options.width; x += step) {
      const Tile tile{x, y, std::min(step, options.width - x), std::min(step, options.height - y)};
      glClearNamedFramebufferfv(many.framebuffer, GL_COLOR, 0, kNothing.data());
      glClearNamedFramebufferfv(many.framebuffer, GL_DEPTH, 0, &kFarthest);
      glBindFramebuffer(GL_DRAW_FRAMEBUFFER, many.framebuffer);
      glViewport(0, 0, tile.width * s, tile.height * s);
      draw_light(many, tile);
      glBlitNamedFramebuffer(many.framebuffer, light.framebuffer, 0, 0, tile.width * s,
                             tile.height * s, 0, 0, tile.width * s, tile.height * s,
                             GL_COLOR_BUFFER_BIT, GL_NEAREST);
      develop(light, finished, tile, options);
      glBindFramebuffer(GL_READ_FRAMEBUFFER, finished.framebuffer);
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
  if (!(options.mark_radius > 0)) throw Error("the radius of marks must be above 0 pixels");
}

}  // namespace brindle
