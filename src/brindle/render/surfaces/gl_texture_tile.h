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

  /// Binds the textures and sets the uniforms of the program.
  void bind(const ShaderProgram& program) const;

 private:
  GlTexture colors_;     ///< the picture's light, or how much of a texel the figure covers
  GlTexture distances_;  ///< of a figure
};

/// The figures of a texture's tiles that shaders/broken_tiles.glsl leaves out. Needs a current
/// context.
class GlBrokenTiles {
 public:
  GlBrokenTiles() = default;
  /// Null: there are none. Throws Error if there is not a word per triangle.
  GlBrokenTiles(const BrokenTiles* broken, std::size_t triangles);

  bool has_any() const { return words_ != 0; }
  /// Nothing where there are none.
  void bind(const ShaderProgram& program) const;

 private:
  GlBuffer words_;
  TileLayout layout_ = TileLayout::single;
  bool split_ = false;
};

}  // namespace brindle
