#include "brindle/render/visible_triangles.h"

#include <array>

namespace brindle {

void VisibleTriangles::draw(const GlSurface& surface, const Camera& camera,
                            const Eigen::Vector4f& tile, const Eigen::Vector2i& size,
                            const Eigen::Vector2i& viewport, Hidden hidden) {
  constexpr std::array<GLuint, 4> kNothing{0, 0, 0, 0};
  constexpr float kFarthest = 1;
  fit_target(samples_, {GL_R32UI}, true, kSamples * size.x(), kSamples * size.y());
  glClearNamedFramebufferuiv(samples_.framebuffer, GL_COLOR, 0, kNothing.data());
  glClearNamedFramebufferfv(samples_.framebuffer, GL_DEPTH, 0, &kFarthest);
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, samples_.framebuffer);
  glViewport(0, 0, kSamples * viewport.x(), kSamples * viewport.y());
  glEnable(GL_DEPTH_TEST);
  if (hidden == Hidden::left_out) leave_out_hidden_side(surface, camera);
  surface.draw(program_, camera, tile);
  glDisable(GL_CULL_FACE);
  glDisable(GL_DEPTH_TEST);
}

void leave_out_hidden_side(const GlSurface& surface, const Camera& camera) {
  // A slice opens surfaces: what was hidden is seen.
  if (camera.slice) return;
  if (surface.hidden_side() == HiddenSide::none || surface.box().contains(eye_of(camera))) return;
  glEnable(GL_CULL_FACE);
  glCullFace(surface.hidden_side() == HiddenSide::back ? GL_BACK : GL_FRONT);
}

void bind_visible(const ShaderProgram& program, const Target& samples) {
  enum Unit { kTriangleUnit = 2, kDepthUnit = 3 };  // after those of GlTextureTile
  program.set("visible", static_cast<int>(kTriangleUnit));
  program.set("visible_depth", static_cast<int>(kDepthUnit));
  glBindTextureUnit(kTriangleUnit, samples.textures[0]);
  glBindTextureUnit(kDepthUnit, samples.textures[1]);
}

}  // namespace brindle
