#include "brindle/render/surfaces/gl_style.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "brindle/error.h"
#include "brindle/gl/gl_buffer.h"
#include "brindle/render/surfaces/gl_surface.h"

namespace brindle {
namespace {

constexpr std::size_t kStyleValues = 8;  // per vertex, as in style_buffers.glsl
constexpr std::size_t kLayerValues = 3;
constexpr std::size_t kSurfacePlace = 6;
constexpr std::size_t kRegionValue = 7;
constexpr std::size_t kTileSize = 0;  // a surface with a texture has no strokes
constexpr std::size_t kMotifPlace = 1;
constexpr float kNoValue = -2e30f;  // below the one of style_buffers.glsl

constexpr GLuint kValuesBinding = 0;
constexpr GLuint kSecondWavesBinding = 1;
constexpr GLuint kSecondPhasesBinding = 2;

[[noreturn]] void refuse_style(const std::string& why) {
  throw Error("cannot draw this surface: " + why);
}

void check_style_count(std::size_t count, std::size_t vertices, const char* what) {
  if (count == 0 || count == vertices) return;
  refuse_style("it has " + std::to_string(count) + " " + what + " for " + std::to_string(vertices) +
               " vertices");
}

void check_strokes(const Strokes& strokes, std::size_t vertices) {
  if (strokes.waves == nullptr || strokes.waves->directions.size() != vertices ||
      strokes.waves->frequencies.size() != vertices || strokes.z.size() != vertices) {
    refuse_style("its strokes need a wave and a phase for each of its " + std::to_string(vertices) +
                 " vertices");
  }
  check_style_count(strokes.widths.size(), vertices, "widths of strokes");
  check_style_count(strokes.opacities.size(), vertices, "opacities of strokes");
  check_style_count(strokes.color_places.size(), vertices, "colours of strokes");
  const float widest = strokes.unit == WidthUnit::period ? 1.0f : 1e4f;
  if (!(strokes.width >= 0 && strokes.width <= widest)) {
    refuse_style("strokes are 0 to 1 periods or 0 to 10000 pixels wide, not " +
                 std::to_string(strokes.width));
  }
  if (!(strokes.opacity >= 0 && strokes.opacity <= 1)) {
    refuse_style("an opacity is a number from 0 to 1, not " + std::to_string(strokes.opacity));
  }
  if (!(strokes.spacing >= 0 && std::isfinite(strokes.spacing))) {
    refuse_style("strokes are 0 or more pixels apart, not " + std::to_string(strokes.spacing));
  }
  if (strokes.tone && !(strokes.tone->none > strokes.tone->full)) {
    refuse_style("strokes end at a tone (" + std::to_string(strokes.tone->none) +
                 ") lighter than the one at which they are full (" +
                 std::to_string(strokes.tone->full) + ")");
  }
}

void check_texture(const StyledSurface& surface) {
  if (!surface.texture) return;
  const RegionTexture& texture = *surface.texture;
  if (!surface.strokes.empty()) refuse_style("it has a texture; leave out its strokes");
  if (texture.waves == nullptr || texture.tiles.empty()) {
    refuse_style("its texture needs waves and a tile");
  }
  check_style_count(texture.values.size(), surface.mesh.vertex_count(), "values of regions");
  check_style_count(texture.sizes.size(), surface.mesh.vertex_count(), "sizes of tiles");
  check_style_count(texture.color_places.size(), surface.mesh.vertex_count(), "colours of motifs");
  for (std::size_t i = 2; i < texture.tiles.size(); ++i) {
    if (!(texture.tiles[i].from > texture.tiles[i - 1].from)) {
      refuse_style("the regions of its texture must begin at rising values");
    }
  }
  if (!texture.shift.allFinite()) refuse_style("its texture is shifted by no number");
}

/// Packs values; NaN and infinities become `kNoValue`.
void put_values(std::span<const float> values, std::size_t which, std::vector<float>& packed) {
  for (std::size_t v = 0; v < values.size(); ++v) {
    packed[kStyleValues * v + which] = std::isfinite(values[v]) ? values[v] : kNoValue;
  }
}

std::vector<float> packed_values(const StyledSurface& surface) {
  std::vector<float> packed(kStyleValues * surface.mesh.vertex_count(), 0.0f);
  for (std::size_t layer = 0; layer < surface.strokes.size(); ++layer) {
    const Strokes& strokes = surface.strokes[layer];
    put_values(strokes.widths, kLayerValues * layer, packed);
    put_values(strokes.opacities, kLayerValues * layer + 1, packed);
    put_values(strokes.color_places, kLayerValues * layer + 2, packed);
  }
  put_values(surface.color_places, kSurfacePlace, packed);
  if (!surface.texture) return packed;
  put_values(surface.texture->values, kRegionValue, packed);
  put_values(surface.texture->sizes, kTileSize, packed);
  put_values(surface.texture->color_places, kMotifPlace, packed);
  return packed;
}

bool is_same(const TextureTile& a, const TextureTile& b) {
  const Image* one = std::get_if<Image>(&a);
  const Image* other = std::get_if<Image>(&b);
  if (one == nullptr || other == nullptr) {
    return one == other && std::get<BuiltInTile>(a) == std::get<BuiltInTile>(b);
  }
  return one->width == other->width && one->height == other->height && one->pixels == other->pixels;
}

}  // namespace

std::shared_ptr<const GlStyle::Tile> GlStyle::tile_of(const TextureTile& source,
                                                      const GlStyle* last) {
  if (last != nullptr) {
    for (const Region& region : last->tiles_) {
      if (is_same(region.tile->source, source)) return region.tile;
    }
  }
  return std::make_shared<const Tile>(Tile{source, GlTextureTile(source)});
}

GlStyle::GlStyle(const StyledSurface& surface, const GlStyle* last)
    : color_(linear_light(surface.color)),
      discards_(surface.between == BetweenStrokes::discarded),
      shading_(surface.shading),
      has_places_(!surface.color_places.empty()) {
  const std::size_t vertices = surface.mesh.vertex_count();
  if (surface.strokes.size() > layers_.size()) {
    refuse_style("a surface has up to two patterns of strokes, not " +
                 std::to_string(surface.strokes.size()));
  }
  if (discards_ && surface.strokes.empty() && !surface.texture) {
    refuse_style(
        "without strokes or tiles, nothing is left of it where it is discarded between them");
  }
  check_style_count(surface.color_places.size(), vertices, "colours");
  check_texture(surface);
  if (surface.texture) {
    shift_ = surface.texture->shift;
    has_regions_ = !surface.texture->values.empty();
    has_sizes_ = !surface.texture->sizes.empty();
    has_motif_places_ = !surface.texture->color_places.empty();
    for (const RegionTile& tile : surface.texture->tiles) {
      tiles_.push_back({tile_of(tile.tile, last), linear_light(tile.color), tile.from,
                        GlBrokenTiles(tile.broken, surface.mesh.triangle_count())});
      whole_tiles_ = whole_tiles_ || tiles_.back().broken.has_any();
    }
  }
  for (const Strokes& strokes : surface.strokes) {
    check_strokes(strokes, vertices);
    Layer& layer = layers_[layer_count_++];
    layer.color = linear_light(strokes.color);
    layer.looks = {strokes.opacity, strokes.width, strokes.spacing};
    layer.follows = {strokes.widths.empty() ? 0.0f : 1.0f, strokes.opacities.empty() ? 0.0f : 1.0f,
                     strokes.color_places.empty() ? 0.0f : 1.0f,
                     strokes.unit == WidthUnit::pixels ? 1.0f : 0.0f};
    if (strokes.tone) {
      layer.tones = {strokes.tone->none, 1 / (strokes.tone->none - strokes.tone->full), 1,
                     strokes.tone->least};
    }
  }
  values_ = buffer_of(packed_values(surface), "values of styles");
  if (layer_count_ < 2) return;
  second_waves_ = buffer_of(packed_waves(*surface.strokes[1].waves), "second waves");
  second_phases_ = buffer_of(surface.strokes[1].z, "second phases");
}

std::string glsl_constant(const char* name, bool value) {
  return std::string("const bool ") + name + (value ? " = true;\n" : " = false;\n");
}

std::string GlStyle::features() const {
  const auto any = [&](auto&& has) {
    return std::any_of(layers_.begin(), layers_.begin() + layer_count_, has);
  };
  return "const int kStrokeLayers = " + std::to_string(layer_count_) + ";\n" +
         glsl_constant("kFollows",
                       any([](const Layer& l) { return !l.follows.head<3>().isZero(0); })) +
         glsl_constant("kPixels", any([](const Layer& l) { return l.follows[3] != 0; })) +
         glsl_constant("kTones", any([](const Layer& l) { return l.tones[2] != 0; })) +
         glsl_constant("kSpacing", any([](const Layer& l) { return l.looks[2] != 0; })) +
         glsl_constant("kSurfacePlaces", has_places_) + glsl_constant("kRegions", has_regions_) +
         glsl_constant("kTileSizes", has_sizes_) +
         glsl_constant("kMotifPlaces", has_motif_places_) +
         glsl_constant("kWholeTiles", whole_tiles_);
}

void GlStyle::bind(const ShaderProgram& program, int samples_per_pixel) const {
  program.set("samples_per_pixel", static_cast<float>(samples_per_pixel));
  program.set("color_map", static_cast<int>(kColorMapUnit));
  program.set("discarded", discards_);
  program.set("middle_of_samples", discards_);
  program.set("shading", shading_);
  program.set("base_color", color_);
  for (std::size_t i = 0; i < layers_.size(); ++i) {
    const std::string index = "[" + std::to_string(i) + "]";
    program.set(("stroke_colors" + index).c_str(), layers_[i].color);
    program.set(("stroke_looks" + index).c_str(), layers_[i].looks);
    program.set(("stroke_follows" + index).c_str(), layers_[i].follows);
    program.set(("stroke_tones" + index).c_str(), layers_[i].tones);
  }
  glBindBufferBase(GL_SHADER_STORAGE_BUFFER, kValuesBinding, values_);
  glBindBufferBase(GL_SHADER_STORAGE_BUFFER, kSecondWavesBinding, second_waves_);
  glBindBufferBase(GL_SHADER_STORAGE_BUFFER, kSecondPhasesBinding, second_phases_);
}

void GlStyle::bind_region(const ShaderProgram& program, std::size_t region) const {
  constexpr float kFar = std::numeric_limits<float>::max();
  const Region& tile = tiles_[region];
  tile.tile->textures.bind(program);
  tile.broken.bind(program);
  program.set("motif_color", tile.color);
  program.set("texture_shift", shift_);
  program.set("region",
              Eigen::Vector2f(region == 0 ? -kFar : tile.from,
                              region + 1 < tiles_.size() ? tiles_[region + 1].from : kFar));
  // Without values, everything is the first region; so are pixels without a tile.
  program.set("first_region", region == 0);
}

}  // namespace brindle
