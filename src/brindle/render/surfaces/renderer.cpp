#include "brindle/renderer.h"

#include <algorithm>

#include "brindle/gl/gl_buffer.h"
#include "brindle/render/surfaces/gl_target.h"
#include "brindle/render/surfaces/surface_picture.h"

namespace brindle {
namespace {

constexpr GLuint kMarksBinding = 0;

std::vector<Vec3> packed_marks(std::span<const Mark> marks) {
  std::vector<Vec3> packed;
  packed.reserve(2 * marks.size());
  for (const Mark& mark : marks) {
    packed.insert(packed.end(), {mark.position, linear_light(mark.color)});
  }
  return packed;
}

}  // namespace

/// A picture of one unstyled surface, with marks.
struct Renderer::State {
  ShaderProgram mark{{"mark.vert"}, {"visible_samples.glsl", "mark.frag"}};
  SurfacePicture picture;
  GlBuffer marks;
  GLsizei mark_count = 0;
  GlVertexArray no_attributes = no_vertex_attributes();

  State() { picture.surfaces.emplace_back(); }
  GlSurface& surface() { return picture.surfaces.front().surface; }
  void upload_marks(std::span<const Mark> added);
  void draw_marks(const Camera& camera, const PicturePart& part, const VisibleSamples& seen,
                  const RenderOptions& options) const;
};

void Renderer::State::upload_marks(std::span<const Mark> added) {
  marks = buffer_of(packed_marks(added), "marks");
  mark_count = static_cast<GLsizei>(added.size());
  check_gl("copying marks to OpenGL");
}

void Renderer::State::draw_marks(const Camera& camera, const PicturePart& part,
                                 const VisibleSamples& seen, const RenderOptions& options) const {
  if (mark_count == 0) return;
  set_camera(mark, camera, part.transform);
  const float radius = mark_radius_of(options);
  mark.set("mark_size", Eigen::Vector2f(2 * radius / static_cast<float>(options.width),
                                        2 * radius / static_cast<float>(options.height)));
  seen.bind(mark);
  glBindBufferBase(GL_SHADER_STORAGE_BUFFER, kMarksBinding, marks);
  glEnable(GL_BLEND);
  glBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  glUseProgram(mark.name());
  glBindVertexArray(no_attributes);
  glDrawArrays(GL_TRIANGLES, 0, 6 * mark_count);
  glDisable(GL_BLEND);
}

float mark_radius_of(const RenderOptions& options) {
  constexpr float kUsual = 6, kLeast = 4;
  const float scale =
      std::min(static_cast<float>(options.width) / 1200, static_cast<float>(options.height) / 900);
  return options.mark_radius.value_or(std::max(kUsual * scale, kLeast));
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
  state_->surface().upload(drawing);
  state_->upload_marks(drawing.marks);
}

void Renderer::update(const DrawingChange& change) {
  state_->surface().update(change);
  state_->upload_marks(change.marks);
}

void Renderer::use_phases(unsigned buffer) { state_->surface().use_phases(buffer); }

Image Renderer::draw(const RenderOptions& options, const Progress& progress) const {
  check_options(options);
  StyledOptions styled;
  styled.render = options;
  PictureScene scene{
      framed_camera(state_->surface().points(), options.camera, options.width, options.height),
      styled};
  const auto draw_marks = [&](const PicturePart& part, const VisibleSamples& seen) {
    state_->draw_marks(scene.camera, part, seen, options);
  };
  return state_->picture.draw(scene, std::nullopt, draw_marks, progress);
}

Image render_picture(const SurfaceDrawing& drawing, const RenderOptions& options,
                     const Progress& progress) {
  check_options(options);
  return drawn_alone<Renderer>(drawing, options, "drawing the picture", progress);
}

}  // namespace brindle
