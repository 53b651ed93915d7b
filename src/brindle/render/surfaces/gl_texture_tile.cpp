#include "brindle/render/surfaces/gl_texture_tile.h"

#include <algorithm>
#include <bit>
#include <vector>

#include "brindle/error.h"
#include "brindle/gl/gl_buffer.h"
#include "brindle/render/surfaces/gl_target.h"

namespace brindle {
namespace {

enum Unit { kColorUnit = 0, kDistanceUnit = 1 };

constexpr GLuint kBrokenTilesBinding = 3;  // as in broken_tiles.glsl

/// Texels along a side of a built-in tile.
constexpr int kMotifSide = 512;

GlTexture repeated_texture(GLenum format, int width, int height, bool smaller_ones) {
  const auto longest = static_cast<unsigned>(std::max(width, height));
  return texture_2d(format, width, height, GL_LINEAR, GL_REPEAT,
                    smaller_ones ? std::bit_width(longest) : 1);
}

/// Signed distances of all texel centres, in rows from v = 0.
std::vector<float> distances_of(BuiltInTile tile) {
  std::vector<float> distances;
  distances.reserve(kMotifSide * kMotifSide);
  for (int y = 0; y < kMotifSide; ++y) {
    for (int x = 0; x < kMotifSide; ++x) {
      distances.push_back(tile_distance(tile, (static_cast<float>(x) + 0.5f) / kMotifSide,
                                        (static_cast<float>(y) + 0.5f) / kMotifSide));
    }
  }
  return distances;
}

GlTexture distance_texture(const std::vector<float>& distances) {
  GlTexture texture = repeated_texture(GL_R32F, kMotifSide, kMotifSide, false);
  glTextureSubImage2D(texture, 0, 0, 0, kMotifSide, kMotifSide, GL_RED, GL_FLOAT, distances.data());
  return texture;
}

GlTexture coverage_texture(std::vector<float> distances) {
  for (float& d : distances) d = std::clamp(0.5f - kMotifSide * d, 0.0f, 1.0f);
  GlTexture texture = repeated_texture(GL_R16F, kMotifSide, kMotifSide, true);
  glTextureSubImage2D(texture, 0, 0, 0, kMotifSide, kMotifSide, GL_RED, GL_FLOAT, distances.data());
  glGenerateTextureMipmap(texture);
  return texture;
}

/// Rows from the bottom, OpenGL's order.
Image upside_down(const Image& image) {
  Image turned(image.width, image.height);
  for (int y = 0; y < image.height; ++y) {
    std::copy_n(&image.at(0, y), image.width, &turned.at(0, image.height - 1 - y));
  }
  return turned;
}

/// Premultiplied alpha, so that mipmaps weigh texels by opacity.
GlTexture transparent_texture(const Image& image) {
  std::vector<Eigen::Vector4f> light;
  light.reserve(image.pixels.size());
  for (const Pixel& pixel : image.pixels) light.push_back(premultiplied_light(pixel));
  GlTexture texture = repeated_texture(GL_RGBA16F, image.width, image.height, true);
  glTextureSubImage2D(texture, 0, 0, 0, image.width, image.height, GL_RGBA, GL_FLOAT, light.data());
  return texture;
}

GlTexture opaque_texture(const Image& image) {
  GlTexture texture = repeated_texture(GL_SRGB8_ALPHA8, image.width, image.height, true);
  glTextureSubImage2D(texture, 0, 0, 0, image.width, image.height, GL_RGBA, GL_UNSIGNED_BYTE,
                      image.pixels.data());
  return texture;
}

GlTexture picture_texture(const Image& picture) {
  GLint longest = 0;
  glGetIntegerv(GL_MAX_TEXTURE_SIZE, &longest);
  const Image image = upside_down(reduced(picture, longest));
  const bool opaque = std::all_of(image.pixels.begin(), image.pixels.end(),
                                  [](const Pixel& pixel) { return pixel.alpha == 255; });
  GlTexture texture = opaque ? opaque_texture(image) : transparent_texture(image);
  glGenerateTextureMipmap(texture);
  return texture;
}

}  // namespace

GlTextureTile::GlTextureTile(const TextureTile& tile) {
  if (const auto* picture = std::get_if<Image>(&tile)) {
    colors_ = picture_texture(*picture);
    return;
  }
  const std::vector<float> distances = distances_of(std::get<BuiltInTile>(tile));
  distances_ = distance_texture(distances);
  colors_ = coverage_texture(distances);
}

void GlTextureTile::bind(const ShaderProgram& program) const {
  program.set("tile_colors", static_cast<int>(kColorUnit));
  program.set("tile_distances", static_cast<int>(kDistanceUnit));
  program.set("tile_is_motif", distances_ != 0);
  program.set("wave_count", 2);
  glBindTextureUnit(kColorUnit, colors_);
  glBindTextureUnit(kDistanceUnit, distances_);
}

GlBrokenTiles::GlBrokenTiles(const BrokenTiles* broken, std::size_t triangles) {
  if (broken == nullptr || broken->words.empty()) return;
  if (broken->words.size() < triangles) {
    throw Error("cannot draw this texture: its broken tiles are those of another mesh");
  }
  words_ = buffer_of(broken->words, "broken tiles");
  layout_ = broken->layout;
  split_ = broken->split;
}

void GlBrokenTiles::bind(const ShaderProgram& program) const {
  program.set("has_broken_tiles", has_any());
  if (!has_any()) return;
  program.set("tile_layout", static_cast<int>(layout_));
  program.set("splits_broken_tiles", split_);
  glBindBufferBase(GL_SHADER_STORAGE_BUFFER, kBrokenTilesBinding, words_);
}

}  // namespace brindle
