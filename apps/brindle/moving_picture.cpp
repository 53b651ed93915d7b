#include "moving_picture.h"

#include <optional>
#include <utility>
#include <vector>

#include "brindle/headless_context.h"
#include "picture_options.h"
#include "video_file.h"

namespace brindle::tool {
namespace {

// Of the paper's Fig. 1: an orange and a blue sphere for two vortex cores.
constexpr Color kPointColors[] = {{0.91f, 0.45f, 0.13f}, {0.16f, 0.50f, 0.84f}};

void add_points(std::span<const Vec3> points, std::vector<Mark>& marks) {
  for (std::size_t k = 0; k < points.size(); ++k) {
    marks.push_back({points[k], kPointColors[k % std::size(kPointColors)]});
  }
}

}  // namespace

struct MovingPicture::State {
  State(FrameOutput to, const PictureOptions& options, bool own_context)
      : output(std::move(to)), view(options.view), render(render_options(options)) {
    if (own_context) context.emplace();
    renderer.emplace();
  }

  FrameOutput output;
  View view;
  RenderOptions render;
  std::optional<HeadlessContext> context;
  std::optional<Renderer> renderer;
  std::optional<VideoFile> video;
  int count = 0;
  std::vector<Vec3> positions;  // as the renderer has them

  void show(const SolvedFrame& solved, const Overlay& overlay);
};

// Copies what the renderer does not have yet.
void MovingPicture::State::show(const SolvedFrame& solved, const Overlay& overlay) {
  const SceneFrame& frame = solved.scene;
  const std::span<const Complex> z =
      solved.phase_buffer != 0 ? std::span<const Complex>() : solved.z;
  if (count == 0) {
    renderer->upload({.mesh = frame.mesh,
                      .normals = frame.normals,
                      .waves = &frame.waves,
                      .z = z,
                      .triangle_colors = overlay.triangle_colors,
                      .marks = overlay.marks});
    if (solved.phase_buffer != 0) renderer->use_phases(solved.phase_buffer);
    positions = frame.mesh.positions;
    return;
  }
  DrawingChange change{.waves = &frame.waves,
                       .z = z,
                       .triangle_colors = overlay.triangle_colors,
                       .marks = overlay.marks};
  if (positions != frame.mesh.positions) {
    positions = frame.mesh.positions;
    change.positions = positions;
    change.normals = frame.normals;
  }
  renderer->update(change);
}

MovingPicture::MovingPicture(FrameOutput output, const PictureOptions& options,
                             int frames_per_second, bool own_context)
    : state_(std::make_unique<State>(std::move(output), options, own_context)) {
  const RenderOptions& render = state_->render;
  if (state_->output.is_video()) {
    state_->video.emplace(state_->output.video,
                          VideoFormat{render.width, render.height, frames_per_second});
  }
}

MovingPicture::~MovingPicture() = default;

void MovingPicture::add(const SolvedFrame& frame) {
  State& s = *state_;
  Overlay overlay = overlay_of(s.view, frame.scene.mesh, frame.scene.waves, frame.corners);
  add_points(frame.scene.points, overlay.marks);
  s.show(frame, overlay);
  const Image image = s.renderer->draw(s.render);
  if (s.context) s.context->check_errors("drawing a frame");
  if (s.video) {
    s.video->add(std::as_bytes(std::span(image.pixels)));
  } else {
    write_png(picture_path(s.output, s.count), image);
  }
  ++s.count;
}

void MovingPicture::finish() {
  if (state_->video) state_->video->finish();
}

}  // namespace brindle::tool
