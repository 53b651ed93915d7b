/// The motif of a tile to which a point belongs.
#pragma once

#include <cmath>
#include <compare>
#include <cstddef>
#include <cstdint>

#include <Eigen/Core>

#include "brindle/broken_tiles.h"

namespace brindle {

/// Half the width of brick joints, in sides of the tile; as in render/shaders/broken_tiles.glsl.
inline constexpr float kHalfJoint = 0.035f;

/// Width of the flanks of motifs in reliefs, in sides of the tile.
inline constexpr float kFlank = 0.04f;

/// The centre of a motif as twice its U and twice its V; it identifies the motif.
struct TileCentre {
  std::int32_t u = 0, v = 0;

  auto operator<=>(const TileCentre&) const = default;
};

inline Eigen::Vector2f place_of(const TileCentre& m) {
  return 0.5f * Eigen::Vector2f(static_cast<float>(m.u), static_cast<float>(m.v));
}

/// The first centre of a kind (0 or 1) in a layout.
inline TileCentre first_middle(TileLayout layout, std::size_t kind) {
  if (layout == TileLayout::courses) return kind == 0 ? TileCentre{1, 0} : TileCentre{0, 1};
  return kind == 0 ? TileCentre{1, 1} : TileCentre{0, 0};
}

/// The kind of the motif with this centre.
inline std::size_t kind_of(TileLayout layout, const TileCentre& m) {
  return layout != TileLayout::single && m.u % 2 == 0 ? 1 : 0;
}

/// The motif that covers a point, or would if it were larger. Keep in step with
/// render/shaders/broken_tiles.glsl.
inline TileCentre motif_at(TileLayout layout, const Eigen::Vector2f& uv) {
  const auto floor = [](float x) { return static_cast<std::int32_t>(std::floor(x)); };
  const TileCentre cell{2 * floor(uv.x()) + 1, 2 * floor(uv.y()) + 1};
  const TileCentre corner{2 * floor(uv.x() + 0.5f), 2 * floor(uv.y() + 0.5f)};
  if (layout == TileLayout::courses) {
    const float to_course = uv.y() - 0.5f * static_cast<float>(corner.v);
    return std::abs(to_course) < 0.25f ? TileCentre{cell.u, corner.v}
                                       : TileCentre{corner.u, cell.v};
  }
  if (layout == TileLayout::single) return cell;
  const Eigen::Vector2f away = (uv - place_of(cell)).cwiseAbs();
  return away.x() + away.y() < 0.5f ? cell : corner;
}

}  // namespace brindle
