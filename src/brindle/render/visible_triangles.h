/// The first pass of a picture: which triangle is seen where.
#pragma once

#include <cstdint>
#include <vector>

#include "brindle/gl/shader_program.h"
#include "brindle/render/gl_surface.h"
#include "brindle/render/gl_target.h"

namespace brindle {

/// Lets a program that includes visible_samples.glsl read these numbers and depths.
void bind_visible(const ShaderProgram& program, const Target& samples);

/// What a first pass shows. One that would show the same need not be drawn again, as long as its
/// target holds it: while stripes or styles change, and nothing moves.
struct ShownPart {
  struct Surface {
    std::uint64_t geometry;
    Camera camera;
    bool operator==(const Surface& other) const;
  };

  std::vector<Surface> surfaces;  ///< none: nothing that could be shown again
  Eigen::Vector4f tile = Eigen::Vector4f::Zero();
  Eigen::Vector2i size = Eigen::Vector2i::Zero(), viewport = Eigen::Vector2i::Zero();
  bool leaves_out_hidden = false;

  bool operator==(const ShownPart&) const = default;
};

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
  ShownPart shown_;  ///< by `samples_`
};

/// Lets OpenGL leave out the side of the surface that nobody sees from there, if it is known, until
/// GL_CULL_FACE is switched off.
void leave_out_hidden_side(const GlSurface& surface, const Camera& camera);

}  // namespace brindle
