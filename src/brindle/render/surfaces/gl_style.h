/// The style of a surface in OpenGL buffers.
#pragma once

#include <array>
#include <memory>
#include <string>
#include <vector>

#include "brindle/gl/gl_name.h"
#include "brindle/gl/shader_program.h"
#include "brindle/render/surfaces/gl_texture_tile.h"
#include "brindle/styled_picture.h"

namespace brindle {

/// The texture unit of the colour map.
inline constexpr GLuint kColorMapUnit = 15;

/// A GLSL constant declaration.
std::string glsl_constant(const char* name, bool value);

/// Needs a current context, as ShaderProgram does.
class GlStyle {
 public:
  /// Copies values and second waves; shares the tiles of `last`. Throws Error for data that do not
  /// fit the surface or are out of range.
  explicit GlStyle(const StyledSurface& surface, const GlStyle* last = nullptr);

  /// Binds for programs that include style_buffers.glsl and strokes.glsl. A light sample has a side
  /// of 1 / `samples_per_pixel`.
  void bind(const ShaderProgram& program, int samples_per_pixel) const;

  bool discards() const { return discards_; }

  /// GLSL constants for the features in use. Software renderers execute all branches, so each
  /// combination has its own program.
  std::string features() const;

  /// The number of tiles of a texture, drawn one after the other; 0 without a texture.
  std::size_t regions() const { return tiles_.size(); }
  /// Binds one region for programs that include region_texture.glsl.
  void bind_region(const ShaderProgram& program, std::size_t region) const;

 private:
  struct Layer {
    Vec3 color = Vec3::Zero();
    Vec3 looks = Vec3::Zero();  ///< as stroke_looks of strokes.glsl
    Eigen::Vector4f follows = Eigen::Vector4f::Zero();
    Eigen::Vector4f tones = Eigen::Vector4f::Zero();
  };

  struct Tile {
    TextureTile source;
    GlTextureTile textures;
  };

  struct Region {
    std::shared_ptr<const Tile> tile;
    Vec3 color;
    float from;
    GlBrokenTiles broken;
  };

  static std::shared_ptr<const Tile> tile_of(const TextureTile& source, const GlStyle* last);

  GlBuffer values_, second_waves_, second_phases_;
  std::array<Layer, 2> layers_;
  int layer_count_ = 0;
  Vec3 color_;
  bool discards_;
  bool shading_;
  bool has_places_;
  std::vector<Region> tiles_;
  Eigen::Vector2f shift_ = Eigen::Vector2f::Zero();
  bool has_regions_ = false;
  bool has_sizes_ = false;  ///< of tiles
  bool has_motif_places_ = false;
  bool whole_tiles_ = false;
};

}  // namespace brindle
