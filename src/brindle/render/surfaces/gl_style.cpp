#include "brindle/render/surfaces/gl_style.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "brindle/gl/gl_buffer.h"
#include "brindle/render/style_checks.h"
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
  check_style(surface);
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
