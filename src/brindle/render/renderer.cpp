#include "brindle/renderer.h"

#include <algorithm>
#include <cmath>

#include "brindle/error.h"
#include "brindle/gl/gl_buffer.h"
#include "brindle/gl/shader_program.h"
#include "brindle/headless_context.h"
#include "brindle/render/gl_surface.h"
#include "brindle/render/tiled_picture.h"

namespace brindle {
namespace {

constexpr int kWantedSamples = 8;

std::vector<Vec3> packed_marks(std::span<const Mark> marks) {
  std::vector<Vec3> packed;
  packed.reserve(2 * marks.size());
  for (const Mark& mark : marks) {
    packed.insert(packed.end(), {mark.position, linear_light(mark.color)});
  }
  return packed;
}

/// Samples a pixel beside supersampling; 0 for one. Where triangles are about as small as pixels
/// each sample would be shaded by itself anyway, and software renderers take five times as long.
int samples_for(std::size_t triangle_count, const RenderOptions& options) {
  const double pixels = static_cast<double>(options.width) * options.height *
                        options.supersampling * options.supersampling;
  if (4 * static_cast<double>(triangle_count) > pixels) return 0;
  const int samples = std::min(kWantedSamples, gl_limit(GL_MAX_SAMPLES));
  return samples > 1 ? samples : 0;
}

}  // namespace

struct Renderer::State {
  ShaderProgram program{{"surface_buffers.glsl", "surface.vert"},
                        {"surface_buffers.glsl", "fragment_phase.glsl", "surface_fragment.glsl",
                         "texture_fragment.glsl", "texture_tile.glsl", "stripe_coverage.glsl",
                         "light.glsl", "striped_surface.frag"}};
  ShaderProgram mark{{"mark.vert"}, {"mark.frag"}};
  TiledPicture picture;
  GlSurface surface;
  GlBuffer marks;
  GLsizei mark_count = 0;

  void upload_marks(std::span<const Mark> added);
  void draw_marks(const Camera& camera, const Eigen::Vector4f& tile,
                  const RenderOptions& options) const;
  void draw_light(const Camera& camera, const Tile& tile, const RenderOptions& options) const;
};

void Renderer::State::upload_marks(std::span<const Mark> added) {
  marks = buffer_of(packed_marks(added), "marks");
  mark_count = static_cast<GLsizei>(added.size());
  check_gl("copying marks to OpenGL");
}

void Renderer::State::draw_marks(const Camera& camera, const Eigen::Vector4f& tile,
                                 const RenderOptions& options) const {
  if (mark_count == 0) return;
  mark.set("origin", camera.origin);
  mark.set("view_from_world", camera.view_from_world);
  mark.set("clip_from_view", camera.clip_from_view);
  mark.set("tile", tile);
  mark.set("mark_size",
           Eigen::Vector2f(2 * options.mark_radius / static_cast<float>(options.width),
                           2 * options.mark_radius / static_cast<float>(options.height)));
  glBindBufferBase(GL_SHADER_STORAGE_BUFFER, GlSurface::kMarksBinding, marks);
  glEnable(GL_BLEND);
  glBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  glDepthMask(GL_FALSE);
  glUseProgram(mark.name());
  glDrawArrays(GL_TRIANGLES, 0, 6 * mark_count);
  glDepthMask(GL_TRUE);
  glDisable(GL_BLEND);
}

void Renderer::State::draw_light(const Camera& camera, const Tile& tile,
                                 const RenderOptions& options) const {
  glEnable(GL_DEPTH_TEST);
  program.set("target_size", Eigen::Vector2f(tile.width * options.supersampling,
                                             tile.height * options.supersampling));
  set_looks(program, options);
  program.set("up", up_seen_by(camera, options.camera.up));
  const Eigen::Vector4f transform = tile_transform(tile, options);
  surface.draw(program, camera, transform);
  draw_marks(camera, transform, options);
  glDisable(GL_DEPTH_TEST);
}

RenderOptions with_faint_stripes(RenderOptions options) {
  options.base_color = {0.900f, 0.900f, 0.895f};
  options.stripe_color = {0.735f, 0.745f, 0.760f};
  return options;
}

Renderer::Renderer() : state_(std::make_unique<State>()) {}

Renderer::~Renderer() = default;
Renderer::Renderer(Renderer&&) noexcept = default;
Renderer& Renderer::operator=(Renderer&&) noexcept = default;

void Renderer::upload(const SurfaceDrawing& drawing) {
  state_->surface.upload(drawing);
  state_->upload_marks(drawing.marks);
}

void Renderer::update(const DrawingChange& change) {
  state_->surface.update(change);
  state_->upload_marks(change.marks);
}

void Renderer::use_phases(unsigned buffer) { state_->surface.use_phases(buffer); }

Image Renderer::draw(const RenderOptions& options) const {
  check_options(options);
  const Camera camera =
      framed_camera(state_->surface.points(), options.camera, options.width, options.height);
  const int samples = samples_for(state_->surface.triangle_count(), options);
  return state_->picture.draw(options, samples, [&](const Target& /*target*/, const Tile& tile) {
    state_->draw_light(camera, tile, options);
  });
}

Image render_picture(const SurfaceDrawing& drawing, const RenderOptions& options) {
  check_options(options);
  const HeadlessContext context;
  Renderer renderer;
  renderer.upload(drawing);
  Image image = renderer.draw(options);
  context.check_errors("drawing the picture");
  return image;
}

}  // namespace brindle
