/// What `brindle stripe` has made.
#pragma once

#include <memory>
#include <optional>
#include <utility>

#include "brindle/broken_tiles.h"
#include "brindle/renderer.h"
#include "brindle/texture_pattern.h"

namespace brindle::tool {

/// Whether tiles are left out where they would be cut.
struct WholeTiles {
  std::optional<bool> asked;                                 ///< nothing: as suits the tile
  std::shared_ptr<const BrokenTileFinder> finder = nullptr;  ///< of the mesh, once it was needed
};

struct Texture {
  TexturePattern pattern;
  TextureTile tile;
  WholeTiles whole;
  std::optional<BrokenTiles> broken;  ///< without a style; nothing: tiles are cut
};

/// Stripes alone, or a texture along two stripe patterns.
struct StripeResult {
  std::variant<StripePattern, Texture> made;

  const Texture* texture() const { return std::get_if<Texture>(&made); }
  /// Of a texture: along the field.
  const StripePattern& stripes() const {
    return texture() != nullptr ? texture()->pattern.u : std::get<StripePattern>(made);
  }
};

}  // namespace brindle::tool
