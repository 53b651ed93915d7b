/// The numbers behind a picture, read back from the shaders that draw it.
#pragma once

#include <array>
#include <string_view>
#include <vector>

#include <epoxy/gl.h>

#include "brindle/gl/gl_buffer.h"
#include "brindle/render/gl_surface.h"
#include "brindle/render/gl_target.h"
#include "brindle/render/tiled_picture.h"

namespace brindle::test {

/// One entry for every pixel, row by row from the top.
struct FragmentImage {
  static constexpr Index kNoTriangle = 0xffffffff;
  std::vector<Complex> z;         ///< as `fragment_phase` gives it; 0 where there is none
  std::vector<Index> triangle;    ///< the triangle seen at the pixel's centre, or kNoTriangle
  std::vector<Vec3> barycentric;  ///< there
};

/// Draws with the picture's shaders but for the last, which writes numbers instead of colours.
/// Needs a current context, as Renderer does.
class FragmentProbe {
 public:
  void upload(const SurfaceDrawing& drawing) { surface_.upload(drawing); }
  void use_phases(unsigned buffer) { surface_.use_phases(buffer); }

  /// One sample a pixel, from the options' camera.
  FragmentImage draw(const RenderOptions& options) const {
    const int width = options.width, height = options.height;
    const Target target = target_of({GL_RG32F, GL_RGBA32F, GL_R32UI}, true, width, height);
    clear(target);
    glBindFramebuffer(GL_FRAMEBUFFER, target.framebuffer);
    glViewport(0, 0, width, height);
    glEnable(GL_DEPTH_TEST);
    surface_.draw(program_, framed_camera(surface_.points(), options.camera, width, height),
                  {1, 1, 0, 0});
    glDisable(GL_DEPTH_TEST);
    return read(target, width, height);
  }

 private:
  static constexpr std::string_view kNumbers = R"glsl(
layout(location = 0) out vec2 z;
layout(location = 1) out vec4 weights;
layout(location = 2) out uint triangle_number;

void main() {
  z = wave_here().z;
  weights = vec4(weights_here(), 0.0);
  triangle_number = triangle;
}
)glsl";

  static void clear(const Target& target) {
    constexpr std::array<float, 4> kNothing{0, 0, 0, 0};
    constexpr std::array<GLuint, 4> kNoTriangles{FragmentImage::kNoTriangle, 0, 0, 0};
    constexpr float kFarthest = 1;
    glClearNamedFramebufferfv(target.framebuffer, GL_COLOR, 0, kNothing.data());
    glClearNamedFramebufferfv(target.framebuffer, GL_COLOR, 1, kNothing.data());
    glClearNamedFramebufferuiv(target.framebuffer, GL_COLOR, 2, kNoTriangles.data());
    glClearNamedFramebufferfv(target.framebuffer, GL_DEPTH, 0, &kFarthest);
  }

  template <class Item>
  static void read(const Target& target, GLenum attachment, GLenum format, GLenum type, int width,
                   int height, std::vector<Item>& items) {
    items.resize(static_cast<std::size_t>(width) * height);
    glNamedFramebufferReadBuffer(target.framebuffer, attachment);
    glReadPixels(0, 0, width, height, format, type, items.data());
    flip_rows(items, width, height);
  }

  static FragmentImage read(const Target& target, int width, int height) {
    FragmentImage image;
    read(target, GL_COLOR_ATTACHMENT0, GL_RG, GL_FLOAT, width, height, image.z);
    read(target, GL_COLOR_ATTACHMENT1, GL_RGB, GL_FLOAT, width, height, image.barycentric);
    read(target, GL_COLOR_ATTACHMENT2, GL_RED_INTEGER, GL_UNSIGNED_INT, width, height,
         image.triangle);
    check_gl("drawing the fragments");
    return image;
  }

  GlSurface surface_;
  ShaderProgram program_{{"surface_buffers.glsl", "surface.vert"},
                         {"surface_buffers.glsl",
                          "fragment_phase.glsl",
                          "surface_fragment.glsl",
                          {"fragment probe", kNumbers}}};
};

}  // namespace brindle::test
