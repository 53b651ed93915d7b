#include "brindle/render/shading.h"

#include "brindle/render/tiled_picture.h"

namespace brindle {

const ShaderProgram& Shading::program_for(const GlSurface& surface) {
  using Sources = std::initializer_list<ShaderSource>;
  const Sources vertex{"full_screen.vert"};
  if (surface.has_texture()) {
    std::optional<ShaderProgram>& program = programs_[kTexture];
    if (!program) {
      program.emplace(vertex,
                      Sources{"surface_buffers.glsl", "surface_point.glsl", "fragment_phase.glsl",
                              "fragment_turns.glsl", "texture_fragment.glsl", "texture_tile.glsl",
                              "texture_pattern.glsl", "triangle_paint.glsl", "light.glsl",
                              "visible_samples.glsl", "shade.frag"});
    }
    return *program;
  }
  if (surface.has_waves()) {
    std::optional<ShaderProgram>& program = programs_[kStripes];
    if (!program) {
      program.emplace(vertex,
                      Sources{"surface_buffers.glsl", "surface_point.glsl", "fragment_phase.glsl",
                              "fragment_turns.glsl", "stripe_wave.glsl", "stripe_coverage.glsl",
                              "stripe_pattern.glsl", "triangle_paint.glsl", "light.glsl",
                              "visible_samples.glsl", "shade.frag"});
    }
    return *program;
  }
  std::optional<ShaderProgram>& program = programs_[kNone];
  if (!program) {
    program.emplace(
        vertex, Sources{"surface_buffers.glsl", "surface_point.glsl", "plain_pattern.glsl",
                        "triangle_paint.glsl", "light.glsl", "visible_samples.glsl", "shade.frag"});
  }
  return *program;
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
  program.set("up", up_seen_by(camera, options.camera.up));
  program.set("target_size", Eigen::Vector2f(size.cast<float>()));
  groups_.shade(program, light, SampleGroups::count(surface, options.quality));
}

}  // namespace brindle
