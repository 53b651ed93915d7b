/// Tiles in OpenGL.
#pragma once

#include "brindle/gl/gl_name.h"
#include "brindle/gl/shader_program.h"
#include "brindle/renderer.h"

namespace brindle {

/// The textures of shaders/texture_tile.glsl. Needs a current OpenGL 4.5 context.
class GlTextureTile {
 public:
  GlTextureTile() = default;
  /// Pictures beyond the driver's texture size are reduced.
  explicit GlTextureTile(const TextureTile& tile);

  /// Binds the textures and sets the program's uniforms.
  void bind(const ShaderProgram& program) const;

 private:
  GlTexture colors_;     ///< colours of a picture, or coverage by a motif
  GlTexture distances_;  ///< of a motif
};

/// The tile motifs that shaders/broken_tiles.glsl leaves out. Needs a current context.
class GlBrokenTiles {
 public:
  GlBrokenTiles() = default;
  /// Null: none. Throws Error unless there is one word per triangle.
  GlBrokenTiles(const BrokenTiles* broken, std::size_t triangles);

  bool has_any() const { return words_ != 0; }
  /// Binds nothing if there are none.
  void bind(const ShaderProgram& program) const;

 private:
  GlBuffer words_;
  TileLayout layout_ = TileLayout::single;
  bool split_ = false;
};

}  // namespace brindle
