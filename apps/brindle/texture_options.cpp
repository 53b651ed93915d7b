#include "texture_options.h"

#include <utility>

#include "brindle/base/error.h"

namespace brindle::tool {

void add_texture_options(CLI::App& app, TextureChoice& choice, WaveOptions& waves) {
  const std::string tiles(built_in_tile_names());
  CLI::Option* texture =
      app.add_option("--texture", choice.tile,
                     "a texture instead of stripes, one tile a period along the field and across "
                     "it: " +
                         tiles + ", or a picture")
          ->type_name("TILE|FILE.png");
  app.add_flag("--oriented", choice.oriented,
               "texture: the field's vectors are meant with their signs, and arrows follow them; "
               "otherwise an orientation is looked for")
      ->needs(texture);
  add_crossing_frequency_options(app, waves, texture);
}

std::optional<TextureTile> chosen_tile(const TextureChoice& choice) {
  if (choice.tile.empty()) return std::nullopt;
  if (const auto tile = built_in_tile(choice.tile)) return *tile;
  try {
    return read_png(choice.tile);
  } catch (const Error& error) {
    throw Error(std::string(error.what()) + " or one of " + std::string(built_in_tile_names()));
  }
}

}  // namespace brindle::tool
