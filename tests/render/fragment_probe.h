/// The numbers behind a picture, read back from the shaders that draw it.
#pragma once

#include <array>
#include <string_view>
#include <vector>

#include <epoxy/gl.h>

#include "brindle/gl/gl_buffer.h"
#include "brindle/render/surfaces/gl_target.h"
#include "brindle/render/surfaces/tiled_picture.h"
#include "brindle/render/surfaces/visible_triangles.h"

namespace brindle::test {

/// One entry for every pixel, row by row from the top.
struct FragmentImage {
  static constexpr Index kNoTriangle = 0xffffffff;
  std::vector<Complex> z;         ///< as `fragment_phase` gives it; 0 where there is none
  std::vector<Index> triangle;    ///< one that is seen in the pixel, or kNoTriangle
  std::vector<Vec3> barycentric;  ///< of the middle of the samples that show it
};

/// Draws with the picture's shaders but for the last, which writes numbers instead of colours.
/// Needs a current context, as Renderer does.
class FragmentProbe {
 public:
  void upload(const SurfaceDrawing& drawing) { drawn_.surface.upload(drawing); }
  void use_phases(unsigned buffer) { drawn_.surface.use_phases(buffer); }

  /// One sample a pixel, from the options' camera.
  FragmentImage draw(const RenderOptions& options) {
    const int width = options.width, height = options.height;
    const Target target = target_of({GL_RG32F, GL_RGBA32F, GL_R32UI}, false, width, height);
    const Camera camera = framed_camera(drawn_.surface.points(), options.camera, width, height);
    const Eigen::Vector4f whole{1, 1, 0, 0};
    const Eigen::Vector2i size(width, height);
    visible_.draw(seen_, std::span(&drawn_, 1), camera, {whole, size}, size, {});
    glBindFramebuffer(GL_FRAMEBUFFER, target.framebuffer);
    glViewport(0, 0, width, height);
    drawn_.surface.bind(program_, camera, whole);
    seen_.bind(program_);
    program_.set("target_size", Eigen::Vector2f(width, height));
    glUseProgram(program_.name());
    glDrawArrays(GL_TRIANGLES, 0, 3);
    return read(target, width, height);
  }

 private:
  static constexpr std::string_view kNumbers = R"glsl(
layout(location = 0) out vec2 z;
layout(location = 1) out vec4 weights;
layout(location = 2) out uint triangle_number;

void main() {
  z = vec2(0.0);
  weights = vec4(0.0);
  triangle_number = 0xffffffffu;
  uvec4 triangles = triangles_here();
  uint number = max(max(triangles.x, triangles.y), max(triangles.z, triangles.w));
  if (number == 0u) return;
  vec2 place = middle_of(shares(equal(triangles, uvec4(number))));
  SurfacePoint p = surface_point(surface_triangle(number - 1u), gl_FragCoord.xy + place,
                                 gl_FragCoord.xy);
  z = wave_at(p).z;
  weights = vec4(p.barycentric, 0.0);
  triangle_number = p.triangle;
}
)glsl";

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

  DrawnSurface drawn_;
  VisibleTriangles visible_;
  VisibleSamples seen_;
  ShaderProgram program_{{"full_screen.vert"},
                         {"surface_buffers.glsl",
                          "surface_point.glsl",
                          "fragment_phase.glsl",
                          "stripe_coverage.glsl",
                          "stripe_pattern.glsl",
                          "visible_samples.glsl",
                          {"fragment probe", kNumbers}}};
};

}  // namespace brindle::test
