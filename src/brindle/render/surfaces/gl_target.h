/// OpenGL framebuffers.
#pragma once

#include <initializer_list>
#include <vector>

#include "brindle/camera.h"
#include "brindle/gl/gl_name.h"
#include "brindle/gl/shader_program.h"

namespace brindle {

/// An empty texture; `filter` and `wrap` are parameters of glTextureParameteri.
GlTexture texture_2d(GLenum format, int width, int height, GLint filter, GLint wrap,
                     GLsizei levels = 1);

/// A framebuffer with its textures: colours first, then an optional depth.
struct Target {
  GlFramebuffer framebuffer;
  std::vector<GlTexture> textures;
  int width = 0;   ///< pixels
  int height = 0;  ///< pixels
};

/// Throws Error if the driver cannot draw into it.
Target target_of(std::initializer_list<GLenum> colors, bool depth, int width, int height);

/// Recreates the target unless it has this size. Throws as `target_of` does.
void fit_target(Target& target, std::initializer_list<GLenum> colors, bool depth, int width,
                int height);

/// Runs a program with full_screen.vert for each pixel of the viewport. `no_attributes` comes from
/// `no_vertex_attributes`.
void fill_viewport(const ShaderProgram& program, GLuint no_attributes);

// The camera as shader uniforms.

/// Sets the uniforms `origin`, `view_from_world`, `clip_from_view`, `slice` and `tile`. `tile` is
/// the part of the picture that fills the target (`tile_transform`).
void set_camera(const ShaderProgram& program, const Camera& camera, const Eigen::Vector4f& tile);

/// RAII: enables the camera's slice for programs whose vertex shaders set `gl_ClipDistance[0]`.
class SlicedDrawing {
 public:
  explicit SlicedDrawing(const Camera& camera);
  ~SlicedDrawing();
  SlicedDrawing(const SlicedDrawing&) = delete;
  SlicedDrawing& operator=(const SlicedDrawing&) = delete;

 private:
  bool sliced_;
};

}  // namespace brindle
