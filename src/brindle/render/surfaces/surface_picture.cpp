#include "brindle/render/surfaces/surface_picture.h"

#include <algorithm>
#include <array>
#include <cstdint>

#include "brindle/render/surfaces/gl_target.h"

namespace brindle {
namespace {

constexpr GLuint kShadowUnit = 14;  // that of surroundings, which the ground does not read

GlTexture shadow_texture(const GroundShadow& shadow) {
  constexpr int kSide = GroundShadow::kSide;
  GlTexture texture = texture_2d(GL_R32F, kSide, kSide, GL_LINEAR, GL_CLAMP_TO_EDGE);
  glTextureSubImage2D(texture, 0, 0, 0, kSide, kSide, GL_RED, GL_FLOAT, shadow.missing.data());
  return texture;
}

}  // namespace

Eigen::Matrix3f ground_axes(UpAxis up) {
  Eigen::Matrix3f axes;
  axes.col(0) = Vec3::Unit((static_cast<int>(up) + 1) % 3);
  axes.col(2) = upright_axes(up).row(1);
  axes.col(1) = axes.col(2).cross(axes.col(0));
  return axes;
}

/// Draws the whole picture coarsely, for the occlusion at the borders of parts.
void SurfacePicture::draw_surroundings(PictureScene& scene) {
  constexpr int kLongestSide = 1024;
  const RenderOptions& render = scene.options.render;
  const int longest = std::max(render.width, render.height);
  const auto side = [&](int pixels) {
    return std::max(1, static_cast<int>(std::int64_t{pixels} * kLongestSide / longest));
  };
  const Eigen::Vector2i size(side(render.width), side(render.height));
  const PicturePart all{tile_transform({0, 0, render.width, render.height}, render), size};
  visible_.draw(surroundings_, surfaces, scene.camera, all, size, render);
  scene.surroundings = &surroundings_;
}

void SurfacePicture::draw_ground(const PictureScene& scene, const GroundShadow& shadow,
                                 GLuint texture, const PicturePart& part, const Target& light) {
  if (!ground_) {
    ground_.emplace(ShaderSources{"full_screen.vert"},
                    ShaderSources{"visible_samples.glsl", "ground_shadow.frag"});
  }
  const Eigen::Matrix3f axes = ground_axes(scene.options.render.camera.up);
  const Vec3 origin = axes.transpose() * scene.camera.origin;
  set_camera(*ground_, scene.camera, part.transform);
  seen_.bind(*ground_);
  ground_->set("target_size", Eigen::Vector2f(part.size.cast<float>()));
  ground_->set("shadow", static_cast<int>(kShadowUnit));
  ground_->set("ground", Vec3((shadow.height - origin.z()) * axes.col(2)));
  ground_->set("across", Vec3(axes.col(0)));
  ground_->set("away", Vec3(axes.col(1)));
  ground_->set("upwards", Vec3(axes.col(2)));
  Eigen::Vector4f place;
  place << shadow.lower - origin.head<2>(), shadow.size.cwiseInverse();
  ground_->set("shadow_place", place);
  glBindTextureUnit(kShadowUnit, texture);
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, light.framebuffer);
  glEnable(GL_BLEND);
  glBlendFunc(GL_ONE, GL_ONE);
  fill_viewport(*ground_, no_attributes_);
  glDisable(GL_BLEND);
}

Image SurfacePicture::draw(PictureScene& scene, const std::optional<GroundShadow>& shadow,
                           const DrawMarks& draw_marks, const Progress& progress) {
  const RenderOptions& render = scene.options.render;
  const Progress drawing = progress.step("drawing");
  // Some drivers defer passes until they are waited for.
  const auto pause = [&] {
    if (render.quality != PictureQuality::final) return;
    glFinish();
    drawing.tick();
  };
  const GlTexture shadow_image = shadow ? shadow_texture(*shadow) : GlTexture();
  if (scene.options.occlusion > 0 && !is_one_tile(render)) draw_surroundings(scene);
  const auto draw_light = [&](const Target& light, const Tile& tile) {
    const int side = shading_side(render);
    const PicturePart part{tile_transform(tile, render),
                           side * Eigen::Vector2i(tile.width, tile.height),
                           side * Eigen::Vector2i(tile.x, tile.y)};
    visible_.draw(seen_, surfaces, scene.camera, part, {light.width, light.height}, render, pause);
    constexpr std::array<float, 4> kNoLight{0, 0, 0, 0};
    glClearNamedFramebufferfv(light.framebuffer, GL_COLOR, 0, kNoLight.data());
    glViewport(0, 0, part.size.x(), part.size.y());
    auto how = Shading::Light::replaced;
    for (const DrawnSurface& drawn : surfaces) {
      if (drawn.surface.triangle_count() == 0) continue;
      shading_.draw(drawn, seen_, scene, part, light, how);
      how = Shading::Light::added;
      pause();
    }
    if (shadow) draw_ground(scene, *shadow, shadow_image, part, light);
    if (draw_marks) {
      glBindFramebuffer(GL_DRAW_FRAMEBUFFER, light.framebuffer);
      draw_marks(part, seen_);
    }
  };
  return tiles_.draw(render, draw_light, progress);
}

}  // namespace brindle
