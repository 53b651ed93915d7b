/// The style of a surface in OpenGL's buffers.
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

/// The texture unit of the colour map that styles follow.
inline constexpr GLuint kColorMapUnit = 15;

/// A declaration of GLSL.
std::string glsl_constant(const char* name, bool value);

/// Needs a current context, as ShaderProgram does.
class GlStyle {
 public:
  /// Copies values and second waves; tiles that `last` has are shared with it. Throws Error for
  /// what does not fit the surface or is out of its range.
  explicit GlStyle(const StyledSurface& surface, const GlStyle* last = nullptr);

  /// Lets a program that includes style_buffers.glsl and strokes.glsl read them. A light sample has
  /// a side of 1 / `samples_per_pixel`.
  void bind(const ShaderProgram& program, int samples_per_pixel) const;

  bool discards() const { return discards_; }

  /// Constants of GLSL for what the style uses. Software renderers execute all of a program, so
  /// each combination has a program of its own.
  std::string features() const;

  /// The number of tiles of a texture, which are drawn one after the other; 0 without a texture.
  std::size_t regions() const { return tiles_.size(); }
  /// Lets a program that includes region_texture.glsl draw this one.
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
  bool has_figure_places_ = false;
  bool whole_tiles_ = false;
};

}  // namespace brindle
