#include "brindle/render/visible_triangles.h"

#include <array>
#include <utility>

namespace brindle {

bool ShownPart::Surface::operator==(const Surface& other) const {
  const Camera& a = camera;
  const Camera& b = other.camera;
  return geometry == other.geometry && a.origin == b.origin &&
         a.view_from_world == b.view_from_world && a.clip_from_view == b.clip_from_view &&
         a.slice.has_value() == b.slice.has_value() &&
         (!a.slice || a.slice->coeffs() == b.slice->coeffs());
}

void VisibleTriangles::draw(const GlSurface& surface, const Camera& camera,
                            const Eigen::Vector4f& tile, const Eigen::Vector2i& size,
                            const Eigen::Vector2i& viewport, Hidden hidden) {
  ShownPart shown{{{surface.geometry(), camera}}, tile, size, viewport, hidden == Hidden::left_out};
  if (shown == shown_) return;
  shown_ = {};
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
  shown_ = std::move(shown);
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
