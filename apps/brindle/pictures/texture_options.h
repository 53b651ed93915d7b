/// Which texture is laid over the surface. A build without OpenGL offers none.
#pragma once

#include <optional>
#include <string>

#include <CLI/CLI.hpp>

#include "brindle/renderer.h"
#include "input/wave_options.h"

namespace brindle::tool {

struct TextureChoice {
  std::string tile;       ///< a built-in tile or a PNG file; empty: no texture
  bool oriented = false;  ///< the field's signs are meant
};

/// --texture, --oriented, --stripes-v and --frequency-v.
void add_texture_options(CLI::App& app, TextureChoice& choice, WaveOptions& waves);

/// Nothing if no texture is asked for. Throws Error if a file cannot be read, CLI::ValidationError
/// for a built-in tile that does not suit a cross field.
std::optional<TextureTile> chosen_tile(const TextureChoice& choice, bool cross);

}  // namespace brindle::tool
