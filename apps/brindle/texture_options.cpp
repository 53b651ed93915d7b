#include "texture_options.h"

#include <filesystem>
#include <utility>
#include <vector>

#include "brindle/base/suggestion.h"
#include "brindle/error.h"
#include "option_values.h"

namespace brindle::tool {
namespace {

bool suits_crosses(BuiltInTile tile) {
  return tile == BuiltInTile::checker || tile == BuiltInTile::dots || tile == BuiltInTile::plus;
}

// Neither a tile nor what looks like a file.
[[noreturn]] void refuse_tile(const std::string& name) {
  const std::string names(built_in_tile_names());
  const std::string meant = nearest(name, split(names, '|'));
  throw CLI::ValidationError("--texture",
                             "'" + name + "' is no file and none of " + names +
                                 (meant.empty() ? "" : "; did you mean '" + meant + "'?"));
}

}  // namespace

void add_texture_options(CLI::App& app, TextureChoice& choice, WaveOptions& waves,
                         CLI::Option* cross) {
  const std::string tiles(built_in_tile_names());
  CLI::Option* texture =
      app.add_option("--texture", choice.tile,
                     "a texture instead of stripes, one tile a period along the field and across "
                     "it: " +
                         tiles + ", or a picture")
          ->type_name("TILE|FILE.png");
  CLI::Option* oriented =
      app.add_flag("--oriented", choice.oriented,
                   "texture: the field's vectors are meant with their signs, and arrows follow "
                   "them; otherwise an orientation is looked for")
          ->needs(texture);
  if (cross != nullptr) oriented->excludes(cross);
  add_crossing_frequency_options(app, waves, texture, cross);
}

std::optional<TextureTile> chosen_tile(const TextureChoice& choice, bool cross) {
  if (choice.tile.empty()) return std::nullopt;
  if (const auto tile = parse_built_in_tile(choice.tile)) {
    if (cross && !suits_crosses(*tile)) {
      throw CLI::ValidationError("--texture", "'" + choice.tile +
                                                  "' does not look the same turned by 90 degrees; "
                                                  "with --cross take checker, dots, plus or a "
                                                  "picture that does");
    }
    return *tile;
  }
  const std::filesystem::path path(choice.tile);
  std::error_code ignored;
  if (!path.has_extension() && !std::filesystem::exists(path, ignored)) refuse_tile(choice.tile);
  try {
    return read_png(choice.tile);
  } catch (const Error& error) {
    throw Error(std::string(error.what()) + " or one of " + std::string(built_in_tile_names()));
  }
}

}  // namespace brindle::tool
