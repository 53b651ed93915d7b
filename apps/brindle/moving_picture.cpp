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
  State(std::vector<FrameOutput> to, const PictureOptions& options, bool own_context)
      : outputs(std::move(to)), view(options.view), render(render_options(options)) {
    if (own_context) context.emplace();
    renderer.emplace();
  }

  std::vector<FrameOutput> outputs;
  View view;
  RenderOptions render;
  std::optional<HeadlessContext> context;
  std::optional<Renderer> renderer;
  std::vector<std::unique_ptr<VideoFile>> videos;  // one per output, or null
  std::size_t count = 0;
  std::vector<Vec3> positions;  // as the renderer has them
  std::vector<Triangle> triangles;
  std::vector<Vec3> framed;  // by the camera

  void show(const SolvedFrame& solved, const Overlay& overlay);
};

// Copies what the renderer does not have yet.
void MovingPicture::State::show(const SolvedFrame& solved, const Overlay& overlay) {
  const SceneFrame& frame = solved.scene;
  const std::span<const Complex> z =
      solved.phase_buffer != 0 ? std::span<const Complex>() : solved.z;
  if (count == 0 || triangles != frame.mesh.triangles ||
      positions.size() != frame.mesh.vertex_count()) {
    if (count == 0) framed = points_of_triangles(frame.mesh);
    renderer->upload({.mesh = frame.mesh,
                      .normals = frame.normals,
                      .waves = &frame.waves,
                      .z = z,
                      .triangle_colors = overlay.triangle_colors,
                      .marks = overlay.marks,
                      .framed = framed});
    if (solved.phase_buffer != 0) renderer->use_phases(solved.phase_buffer);
    positions = frame.mesh.positions;
    triangles = frame.mesh.triangles;
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

MovingPicture::MovingPicture(std::vector<FrameOutput> outputs, const PictureOptions& options,
                             int frames_per_second, bool own_context)
    : state_(std::make_unique<State>(std::move(outputs), options, own_context)) {
  const RenderOptions& render = state_->render;
  const VideoFormat format{render.width, render.height, frames_per_second};
  for (const FrameOutput& output : state_->outputs) {
    state_->videos.push_back(output.is_video() ? std::make_unique<VideoFile>(output.video, format)
                                               : nullptr);
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
  for (std::size_t i = 0; i < s.outputs.size(); ++i) {
    if (s.videos[i]) {
      s.videos[i]->add(std::as_bytes(std::span(image.pixels)));
    } else {
      write_png(frame_path(s.outputs[i], s.count), image);
    }
  }
  ++s.count;
}

void MovingPicture::finish() {
  for (const auto& video : state_->videos) {
    if (video) video->finish();
  }
}

}  // namespace brindle::tool
