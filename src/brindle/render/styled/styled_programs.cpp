#include "brindle/render/styled/styled_programs.h"

#include <utility>

namespace brindle {
namespace {

std::vector<ShaderSource> with_surface(const std::string& features,
                                       std::vector<ShaderSource> style) {
  std::vector<ShaderSource> sources = {{"features", features},
                                       "surface_buffers.glsl",
                                       "surface_point.glsl",
                                       "fragment_phase.glsl",
                                       "fragment_turns.glsl"};
  sources.insert(sources.end(), style.begin(), style.end());
  return sources;
}

}  // namespace

const ShaderProgram& StyledPrograms::visibility(Parts parts, const char* name,
                                                const std::string& features, Sources style) {
  const bool listed = parts == Parts::listed;
  const Sources end = listed ? Sources{"listed_triangles.glsl", "listed_visibility.frag"}
                             : Sources{"parts_visibility.frag"};
  style.insert(style.end(), end.begin(), end.end());
  return programs_
      .try_emplace((listed ? "listed " : "") + (name + features),
                   Sources{listed ? "full_screen.vert" : "visible_triangles.vert"},
                   with_surface(features, std::move(style)))
      .first->second;
}

const ShaderProgram& StyledPrograms::shading(const char* name, const std::string& features,
                                             bool occlusion, Sources style) {
  const char* open_share = occlusion ? "occlusion.glsl" : "no_occlusion.glsl";
  style.insert(style.end(), {"tone.glsl", "depth_cue.glsl", "visible_samples.glsl", open_share,
                             "styled_shade.frag"});
  return programs_
      .try_emplace(name + features + open_share, Sources{"full_screen.vert"},
                   with_surface(features, std::move(style)))
      .first->second;
}

const ShaderProgram& StyledPrograms::whole() {
  if (!whole_) {
    whole_.emplace(Sources{"visible_triangles.vert"}, Sources{"styled_visibility.frag"});
  }
  return *whole_;
}

const ShaderProgram& StyledPrograms::list() {
  if (!list_) {
    list_.emplace(Sources{"visible_triangles.vert"},
                  Sources{"listed_triangles.glsl", "list_triangles.frag"});
  }
  return *list_;
}

const ShaderProgram& StyledPrograms::spread() {
  if (!spread_) spread_.emplace(Sources{"full_screen.vert"}, Sources{"spread_samples.frag"});
  return *spread_;
}

const ShaderProgram& StyledPrograms::between_strokes(const std::string& features, Parts parts) {
  return visibility(parts, "between strokes\n", features,
                    {"stripe_middle.glsl", "light.glsl", "picture_light.glsl", "style_buffers.glsl",
                     "color_scale.glsl", "strokes.glsl", "tone.glsl", "strokes_seen.glsl"});
}

const ShaderProgram& StyledPrograms::beside_tiles(const std::string& features, Parts parts) {
  return visibility(
      parts, "beside tiles\n", features,
      {"style_buffers.glsl", "color_scale.glsl", "texture_fragment.glsl", "texture_tile.glsl",
       "broken_tiles.glsl", "region_texture.glsl", "tiles_seen.glsl"});
}

const ShaderProgram& StyledPrograms::strokes(const std::string& features, bool occlusion) {
  return shading("strokes\n", features, occlusion,
                 {"stripe_coverage.glsl", "light.glsl", "picture_light.glsl", "style_buffers.glsl",
                  "color_scale.glsl", "strokes.glsl", "stroke_layers.glsl"});
}

const ShaderProgram& StyledPrograms::texture(const std::string& features, bool occlusion) {
  return shading(
      "texture\n", features, occlusion,
      {"light.glsl", "picture_light.glsl", "style_buffers.glsl", "color_scale.glsl",
       "texture_fragment.glsl", "texture_tile.glsl", "broken_tiles.glsl", "region_texture.glsl"});
}

const ShaderProgram& StyledPrograms::ground() {
  if (!ground_) {
    ground_.emplace(Sources{"full_screen.vert"},
                    Sources{"visible_samples.glsl", "ground_shadow.frag"});
  }
  return *ground_;
}

}  // namespace brindle
