#include "brindle/render/shading.h"

#include <utility>
#include <vector>

#include "brindle/render/tiled_picture.h"

namespace brindle {

namespace {

const std::vector<ShaderSource> kFullScreen = {"full_screen.vert"};

/// What says the colour at a point of the surface, between what all have.
std::vector<ShaderSource> fragment_sources(std::vector<ShaderSource> pattern) {
  std::vector<ShaderSource> sources = {"surface_buffers.glsl", "surface_point.glsl"};
  sources.insert(sources.end(), pattern.begin(), pattern.end());
  sources.insert(sources.end(), {"triangle_paint.glsl", "light.glsl", "picture_light.glsl",
                                 "visible_samples.glsl", "shade.frag"});
  return sources;
}

}  // namespace

const ShaderProgram& Shading::program_for(const GlSurface& surface) {
  const auto program = [this](std::size_t kind, std::vector<ShaderSource> pattern) -> auto& {
    std::optional<ShaderProgram>& made = programs_[kind];
    if (!made) made.emplace(kFullScreen, fragment_sources(std::move(pattern)));
    return *made;
  };
  if (surface.has_texture()) {
    const bool whole = surface.has_broken_tiles();
    return program(whole ? kWholeTiles : kTexture, {{"features", whole_tiles_feature(whole)},
                                                    "fragment_phase.glsl",
                                                    "fragment_turns.glsl",
                                                    "texture_fragment.glsl",
                                                    "texture_tile.glsl",
                                                    "broken_tiles.glsl",
                                                    "texture_pattern.glsl"});
  }
  if (surface.has_waves()) {
    return program(kStripes, {"fragment_phase.glsl", "fragment_turns.glsl", "stripe_wave.glsl",
                              "stripe_coverage.glsl", "stripe_pattern.glsl"});
  }
  return program(kNone, {"plain_pattern.glsl"});
}

void Shading::draw(const GlSurface& surface, const VisibleTriangles& visible, const Camera& camera,
                   const Eigen::Vector4f& tile, const Target& light, const Eigen::Vector2i& size,
                   const RenderOptions& options) {
  constexpr std::array<float, 4> kNothing{0, 0, 0, 0};
  glClearNamedFramebufferfv(light.framebuffer, GL_COLOR, 0, kNothing.data());
  if (surface.triangle_count() == 0) return;
  const ShaderProgram& program = program_for(surface);
  groups_.find(surface, visible.samples(), camera, tile, light, size);
  surface.bind(program, camera, tile);
  visible.bind(program);
  set_looks(program, options);
  set_light(program, camera, options);
  program.set("target_size", Eigen::Vector2f(size.cast<float>()));
  groups_.shade(program, light, SampleGroups::count(surface, options.quality));
}

}  // namespace brindle
