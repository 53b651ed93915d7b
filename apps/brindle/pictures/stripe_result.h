/// What `brindle stripe` has made.
#pragma once

#include <optional>
#include <utility>

#include "brindle/renderer.h"
#include "brindle/texture_pattern.h"

namespace brindle::tool {

struct Texture {
  TexturePattern pattern;
  TextureTile tile;
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
