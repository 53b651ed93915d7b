/// A tile in OpenGL.
#pragma once

#include "brindle/gl/gl_name.h"
#include "brindle/gl/shader_program.h"
#include "brindle/renderer.h"

namespace brindle {

/// The textures that shaders/texture_tile.glsl reads. Needs a current OpenGL 4.5 context.
class GlTextureTile {
 public:
  GlTextureTile() = default;
  /// Pictures larger than the driver's textures are reduced.
  explicit GlTextureTile(const TextureTile& tile);

  /// Binds the textures and tells the program of them.
  void bind(const ShaderProgram& program) const;

 private:
  GlTexture colors_;     ///< the picture's light, or how much of a texel the figure covers
  GlTexture distances_;  ///< of a figure
};

}  // namespace brindle
