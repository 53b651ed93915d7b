#include "pictures/texture_options.h"

#include <filesystem>
#include <utility>
#include <vector>

#include "brindle/base/text.h"
#include "brindle/error.h"
#include "brindle/recipe/wave_report.h"
#include "brindle/render/parsed_words.h"
#include "cli/command_line.h"
#include "cli/option_fields.h"

namespace brindle::tool {
namespace {

// Rejects names that are neither tiles nor files.
[[noreturn]] void refuse_tile(const std::string& name) {
  const std::string names(built_in_tile_names());
  const std::string meant = nearest(name, split(names, '|'));
  throw CLI::ValidationError("--texture",
                             "'" + name + "' is no file and none of " + names +
                                 (meant.empty() ? "" : "; did you mean '" + meant + "'?"));
}

std::optional<bool> parse_whole(std::string_view name) {
  if (name == "whole") return true;
  if (name == "cut") return false;
  return std::nullopt;
}

}  // namespace

void add_texture_options(CLI::App& app, TextureChoice& choice, WaveOptions& waves) {
  add_fields(app, choice);
  add_named_option(app, "--tiles", choice.whole, parse_whole);
  waves.visit_texture(AddField(app));
}

Drawn drawn_by(const TextureChoice& choice, bool has_tiles) {
  if (!has_tiles) return Drawn::stripes;
  const bool picture = !choice.tile.empty() && !parse_built_in_tile(choice.tile);
  return picture ? Drawn::pictures : Drawn::motifs;
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

std::shared_ptr<const BrokenTiles> Texture::broken(const Mesh& mesh) const {
  return whole.broken(mesh.triangles, pattern.waves, tile);
}

std::string warning_of_tiles(const Texture* texture, const Mesh& mesh) {
  const auto broken = texture == nullptr ? nullptr : texture->broken(mesh);
  return broken == nullptr ? "" : tile_warning(*broken, mesh.triangle_count());
}

}  // namespace brindle::tool
