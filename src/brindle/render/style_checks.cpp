#include "brindle/render/style_checks.h"

#include <cmath>
#include <string>

#include "brindle/error.h"

namespace brindle {
namespace {

[[noreturn]] void refuse(const std::string& why) {
  throw Error("cannot draw this surface: " + why);
}

void check_count(std::size_t count, std::size_t vertices, const char* what) {
  if (count == 0 || count == vertices) return;
  refuse("it has " + std::to_string(count) + " " + what + " for " + std::to_string(vertices) +
         " vertices");
}

void check_strokes(const Strokes& strokes, std::size_t vertices) {
  if (strokes.waves == nullptr || strokes.waves->directions.size() != vertices ||
      strokes.waves->frequencies.size() != vertices || strokes.z.size() != vertices) {
    refuse("its strokes need a wave and a phase for each of its " + std::to_string(vertices) +
           " vertices");
  }
  check_count(strokes.widths.size(), vertices, "widths of strokes");
  check_count(strokes.opacities.size(), vertices, "opacities of strokes");
  check_count(strokes.color_places.size(), vertices, "colours of strokes");
  const float widest = strokes.unit == WidthUnit::period ? 1.0f : 1e4f;
  if (!(strokes.width >= 0 && strokes.width <= widest)) {
    refuse("strokes are 0 to 1 periods or 0 to 10000 pixels wide, not " +
           std::to_string(strokes.width));
  }
  if (!(strokes.opacity >= 0 && strokes.opacity <= 1)) {
    refuse("an opacity is a number from 0 to 1, not " + std::to_string(strokes.opacity));
  }
  if (!(strokes.spacing >= 0 && std::isfinite(strokes.spacing))) {
    refuse("strokes are 0 or more pixels apart, not " + std::to_string(strokes.spacing));
  }
  if (strokes.tone && !(strokes.tone->none > strokes.tone->full)) {
    refuse("strokes end at a tone (" + std::to_string(strokes.tone->none) +
           ") lighter than the one at which they are full (" + std::to_string(strokes.tone->full) +
           ")");
  }
}

void check_texture(const StyledSurface& surface) {
  if (!surface.texture) return;
  const RegionTexture& texture = *surface.texture;
  if (!surface.strokes.empty()) refuse("it has a texture; leave out its strokes");
  if (texture.waves == nullptr || texture.tiles.empty()) {
    refuse("its texture needs waves and a tile");
  }
  check_count(texture.values.size(), surface.mesh.vertex_count(), "values of regions");
  check_count(texture.sizes.size(), surface.mesh.vertex_count(), "sizes of tiles");
  check_count(texture.color_places.size(), surface.mesh.vertex_count(), "colours of motifs");
  for (std::size_t i = 2; i < texture.tiles.size(); ++i) {
    if (!(texture.tiles[i].from > texture.tiles[i - 1].from)) {
      refuse("the regions of its texture must begin at rising values");
    }
  }
  if (!texture.shift.allFinite()) refuse("its texture is shifted by no number");
}

}  // namespace

void check_style(const StyledSurface& surface) {
  const std::size_t vertices = surface.mesh.vertex_count();
  if (surface.strokes.size() > kMostStrokes) {
    refuse("a surface has up to two patterns of strokes, not " +
           std::to_string(surface.strokes.size()));
  }
  if (surface.between == BetweenStrokes::discarded && surface.strokes.empty() && !surface.texture) {
    refuse("without strokes or tiles, nothing is left of it where it is discarded between them");
  }
  check_count(surface.normals.size(), vertices, "normals");
  check_count(surface.color_places.size(), vertices, "colours");
  check_texture(surface);
  for (const Strokes& strokes : surface.strokes) check_strokes(strokes, vertices);
}

}  // namespace brindle
