/// The result of `brindle stripe`.
#pragma once

#include <memory>
#include <string>
#include <utility>

#include "brindle/renderer.h"
#include "brindle/texture_pattern.h"
#include "pictures/whole_tiles.h"

namespace brindle::tool {

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
