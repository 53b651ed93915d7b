/// The first pass of a picture: which triangle is seen where.
#pragma once

#include "brindle/gl/shader_program.h"
#include "brindle/render/gl_surface.h"
#include "brindle/render/gl_target.h"

namespace brindle {

/// Lets a program that includes visible_samples.glsl read these numbers and depths.
void bind_visible(const ShaderProgram& program, const Target& samples);

/// Numbers and depths of the triangles that are seen, in samples of which each pixel of the shading
/// has two by two. Kept from picture to picture.
class VisibleTriangles {
 public:
  /// What is done with the hidden side of a surface, on which half of the time is spent.
  enum class Hidden { drawn, left_out };

  /// Samples along the side of a pixel.
  static constexpr int kSamples = 2;

  /// Draws the surface for a shading of at most `size` pixels, of which it fills `viewport`. Throws
  /// Error if the driver cannot draw into samples for as many.
  void draw(const GlSurface& surface, const Camera& camera, const Eigen::Vector4f& tile,
            const Eigen::Vector2i& size, const Eigen::Vector2i& viewport,
            Hidden hidden = Hidden::drawn);

  /// Lets a program that includes visible_samples.glsl read what was drawn.
  void bind(const ShaderProgram& program) const { bind_visible(program, samples_); }

  const Target& samples() const { return samples_; }

 private:
  ShaderProgram program_{{"visible_triangles.vert"}, {"visible_triangles.frag"}};
  Target samples_;
};

/// Lets OpenGL leave out the side of the surface that nobody sees from there, if it is known, until
/// GL_CULL_FACE is switched off.
void leave_out_hidden_side(const GlSurface& surface, const Camera& camera);

}  // namespace brindle
