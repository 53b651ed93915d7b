/// What pictures show: stripes, or a texture.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>

#include "brindle/broken_tiles.h"
#include "brindle/renderer.h"
#include "brindle/texture_pattern.h"

namespace brindle::tool {

/// The broken motifs of one texture's tiles, computed on demand and cached. Copies share the cache.
class WholeTiles {
 public:
  /// Whether broken tiles are left out; empty: the tile's default.
  explicit WholeTiles(std::optional<bool> asked = std::nullopt);

  /// For another texture on the same mesh, with an empty cache.
  WholeTiles of_next_texture(std::optional<bool> asked) const;

  /// The motifs to examine, shifted by `shift` tiles and at most `size` of their cell; empty if
  /// tiles are cut.
  std::optional<TileMotifs> motifs_of(const TextureTile& tile,
                                      const Eigen::Vector2f& shift = {0, 0}, float size = 1) const;

  /// The broken ones; null if tiles are cut. `triangles` and `waves` are the texture's.
  std::shared_ptr<const BrokenTiles> broken(std::span<const Triangle> triangles,
                                            const TextureWaves& waves, const TextureTile& tile,
                                            const Eigen::Vector2f& shift = {0, 0},
                                            float size = 1) const;

  /// Stores a result computed elsewhere.
  void know(const TileMotifs& motifs, BrokenTiles broken);

 private:
  struct Found;
  std::optional<bool> asked_;
  std::shared_ptr<Found> found_;
};

struct Texture {
  TexturePattern pattern;
  TextureTile tile;
  WholeTiles whole;

  /// The broken motifs of the tile without a style, on the pattern's mesh; null if tiles are cut.
  std::shared_ptr<const BrokenTiles> broken(const Mesh& mesh) const;
};

/// A line if nearly all motifs of a texture are left out, or nothing.
std::string warning_of_tiles(const Texture* texture, const Mesh& mesh);

/// Stripes alone, or a texture along two stripe patterns.
struct StripeResult {
  std::variant<StripePattern, Texture> made;

  const Texture* texture() const { return std::get_if<Texture>(&made); }
  /// For a texture, those along the field.
  const StripePattern& stripes() const {
    return texture() != nullptr ? texture()->pattern.u : std::get<StripePattern>(made);
  }
};

}  // namespace brindle::tool
