#include "jobs/moving_picture.h"

#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "brindle/headless_context.h"
#include "brindle/render/slice_refusal.h"
#include "pictures/frame_output.h"
#include "pictures/picture.h"
#include "pictures/video_file.h"

namespace brindle::tool {
namespace {

void add_points(std::span<const Vec3> points, std::vector<Mark>& marks) {
  for (std::size_t k = 0; k < points.size(); ++k) {
    marks.push_back({points[k], kPointColors[k % std::size(kPointColors)]});
  }
}

// Empty if the renderer reads them from a buffer.
std::span<const Complex> phases_of(const SolvedFrame& solved) {
  return solved.phase_buffer != 0 ? std::span<const Complex>() : solved.z;
}

/// Stripes, branches or errors, with points as marks.
class PlainFrames : public FramePainter {
 public:
  explicit PlainFrames(const PictureOptions& options)
      : options_(options), render_(render_options(options, Eigen::Vector3d::Zero())) {}

  Image paint(const SolvedFrame& frame) override {
    if (first_) render_ = render_options(options_, frame.scene.mesh.origin);
    Overlay overlay = overlay_of(options_.view, frame.scene.mesh, frame.scene.waves, frame.corners);
    add_points(frame.scene.points, overlay.marks);
    show(frame, overlay);
    first_ = false;
    nothing_left_ = slice_refusal(
        frame.scene.mesh, framed_camera(framed_, render_.camera, render_.width, render_.height),
        "--slice");
    return renderer_.draw(render_);
  }

  FrameNotes notes() const override { return {nothing_left_, ""}; }

 private:
  void upload(const SolvedFrame& solved, const Overlay& overlay);
  void show(const SolvedFrame& solved, const Overlay& overlay);
  bool has_waves(const WaveSet& waves);

  const PictureOptions& options_;
  RenderOptions render_;
  Renderer renderer_;
  bool first_ = true;
  std::string nothing_left_;
  std::vector<Vec3> positions_;  // those of the renderer
  std::vector<Triangle> triangles_;
  std::vector<Vec3> framed_;  // framed by the camera
  DirectionField directions_;
  FrequencyField frequencies_;
};

// Whether the renderer already has these waves; records them otherwise.
bool PlainFrames::has_waves(const WaveSet& waves) {
  if (directions_ == waves.directions && frequencies_ == waves.frequencies) return true;
  directions_ = waves.directions;
  frequencies_ = waves.frequencies;
  return false;
}

void PlainFrames::upload(const SolvedFrame& solved, const Overlay& overlay) {
  const SceneFrame& frame = solved.scene;
  if (first_) framed_ = points_of_triangles(frame.mesh);
  renderer_.upload({.mesh = frame.mesh,
                    .normals = frame.normals,
                    .waves = &frame.waves,
                    .z = phases_of(solved),
                    .triangle_colors = overlay.triangle_colors,
                    .marks = overlay.marks,
                    .framed = framed_});
  if (solved.phase_buffer != 0) renderer_.use_phases(solved.phase_buffer);
  positions_ = frame.mesh.positions;
  triangles_ = frame.mesh.triangles;
  has_waves(frame.waves);
}

// Uploads only what has changed.
void PlainFrames::show(const SolvedFrame& solved, const Overlay& overlay) {
  const SceneFrame& frame = solved.scene;
  if (first_ || triangles_ != frame.mesh.triangles ||
      positions_.size() != frame.mesh.vertex_count()) {
    return upload(solved, overlay);
  }
  DrawingChange change{.waves = has_waves(frame.waves) ? nullptr : &frame.waves,
                       .z = phases_of(solved),
                       .triangle_colors = overlay.triangle_colors,
                       .marks = overlay.marks};
  if (positions_ != frame.mesh.positions) {
    positions_ = frame.mesh.positions;
    change.positions = positions_;
    change.normals = frame.normals;
  }
  renderer_.update(change);
}

}  // namespace

struct MovingPicture::State {
  State(std::vector<FrameOutput> to, const PictureOptions& options, bool own_context,
        const FrameStyle* style)
      : outputs(std::move(to)) {
    if (own_context) context.emplace();
    painter = style != nullptr ? make_styled_frames(*style, options)
                               : std::make_unique<PlainFrames>(options);
  }

  std::vector<FrameOutput> outputs;
  std::optional<HeadlessContext> context;
  std::unique_ptr<FramePainter> painter;
  std::vector<std::unique_ptr<VideoFile>> videos;  // one per output, or null
  std::size_t count = 0;
  FrameWriter writer;  // declared last: ends before the videos do

  void write(Image image);
};

// Encodes and writes while the next frame is solved and drawn.
void MovingPicture::State::write(Image image) {
  const auto frame = std::make_shared<const Image>(std::move(image));
  writer.add([this, frame, number = count] {
    for (std::size_t i = 0; i < outputs.size(); ++i) {
      if (videos[i]) {
        videos[i]->add(std::as_bytes(std::span(frame->pixels)));
      } else {
        write_png(frame_path(outputs[i], number), *frame);
      }
    }
  });
}

MovingPicture::MovingPicture(std::vector<FrameOutput> outputs, const PictureOptions& options,
                             int frames_per_second, bool own_context, const FrameStyle* style)
    : state_(std::make_unique<State>(std::move(outputs), options, own_context, style)) {
  const VideoFormat format{options.render.width, options.render.height, frames_per_second};
  for (const FrameOutput& output : state_->outputs) {
    state_->videos.push_back(output.is_video() ? std::make_unique<VideoFile>(output.video, format)
                                               : nullptr);
  }
}

MovingPicture::~MovingPicture() = default;

FrameNotes MovingPicture::add(const SolvedFrame& frame) {
  State& s = *state_;
  Image image = s.painter->paint(frame);
  if (s.context) s.context->check_errors("drawing a frame");
  s.write(std::move(image));
  ++s.count;
  return s.painter->notes();
}

void MovingPicture::finish() {
  state_->writer.finish();
  for (const auto& video : state_->videos) {
    if (video) video->finish();
  }
}

}  // namespace brindle::tool
