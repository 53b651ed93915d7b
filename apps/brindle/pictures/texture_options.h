/// Options of the texture.
#pragma once

#include <optional>
#include <span>
#include <string>

#include <CLI/CLI.hpp>

#include "brindle/renderer.h"
#include "input/wave_options.h"
#include "pictures/stripe_result.h"
#include "pictures/style_options.h"

namespace brindle::tool {

struct TextureChoice {
  std::string tile;           ///< a built-in tile or a PNG file; empty: no texture
  std::optional<bool> whole;  ///< --tiles whole or cut; empty: the tile's default

  /// Calls `add("--option", field)` for each option that sets a field.
  template <class Add>
  void visit(const Add& add) {
    add("--texture", tile);
  }
};

/// --texture, --oriented, --tiles, --stripes-v and --frequency-v.
void add_texture_options(CLI::App& app, TextureChoice& choice, WaveOptions& waves);

/// The marks of patterns with tiles or, without any, stripes.
Drawn drawn_by(const TextureChoice& choice, bool has_tiles);

/// Empty without a texture. Throws Error if a file cannot be read, CLI::ValidationError for a
/// built-in tile without the symmetry of a cross field.
std::optional<TextureTile> chosen_tile(const TextureChoice& choice, bool cross);

}  // namespace brindle::tool
