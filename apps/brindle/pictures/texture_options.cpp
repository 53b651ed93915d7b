#include "pictures/texture_options.h"

#include <filesystem>
#include <utility>
#include <vector>

#include "brindle/base/suggestion.h"
#include "brindle/error.h"
#include "brindle/render/parsed_words.h"
#include "cli/command_line.h"
#include "cli/option_values.h"

namespace brindle::tool {
namespace {

// Neither a tile nor what looks like a file.
[[noreturn]] void refuse_tile(const std::string& name) {
  const std::string names(built_in_tile_names());
  const std::string meant = nearest(name, split(names, '|'));
  throw CLI::ValidationError("--texture",
                             "'" + name + "' is no file and none of " + names +
                                 (meant.empty() ? "" : "; did you mean '" + meant + "'?"));
}

}  // namespace

void add_texture_options(CLI::App& app, TextureChoice& choice, WaveOptions& waves) {
  app.add_option("--texture", choice.tile);
  app.add_flag("--oriented", choice.oriented);
  add_crossing_frequency_options(app, waves);
}

std::optional<TextureTile> chosen_tile(const TextureChoice& choice, bool cross) {
  if (choice.tile.empty()) return std::nullopt;
  if (const auto tile = parse_built_in_tile(choice.tile)) {
    if (cross) refuse_usage([&] { check_tile_of_crosses(choice.tile); });
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
