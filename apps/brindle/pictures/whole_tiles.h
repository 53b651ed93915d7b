/// Tiles that are left out of a texture rather than cut.
#pragma once

#include <memory>
#include <optional>
#include <span>

#include "brindle/broken_tiles.h"
#include "brindle/renderer.h"

namespace brindle::tool {

/// The figures of one texture's tiles that are broken: found when they are first asked for, and
/// kept for all that draw it. Copies share what was found.
class WholeTiles {
 public:
  /// Whether tiles are left out where they would be cut; nothing: as suits the tile.
  explicit WholeTiles(std::optional<bool> asked = std::nullopt);

  /// Of another texture on the same mesh, of which nothing is known yet.
  WholeTiles of_next_texture(std::optional<bool> asked) const;

  /// The figures to look after, shifted by so many tiles and at most `size` of their place; nothing
  /// where tiles are cut.
  std::optional<TileFigures> figures_of(const TextureTile& tile,
                                        const Eigen::Vector2f& shift = {0, 0},
                                        float size = 1) const;

  /// Which of them are broken; null where tiles are cut. `triangles` and `waves` are the texture's.
  std::shared_ptr<const BrokenTiles> broken(std::span<const Triangle> triangles,
                                            const TextureWaves& waves, const TextureTile& tile,
                                            const Eigen::Vector2f& shift = {0, 0},
                                            float size = 1) const;

  /// What somebody else has found.
  void know(const TileFigures& figures, BrokenTiles broken);

 private:
  struct Found;
  std::optional<bool> asked_;
  std::shared_ptr<Found> found_;
};

}  // namespace brindle::tool
