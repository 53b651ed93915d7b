#include "jobs/styled_frames.h"

#include <cmath>
#include <map>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "brindle/frequency_field.h"
#include "brindle/legend.h"
#include "brindle/recipe/wave_report.h"
#include "brindle/render/slice_refusal.h"
#include "brindle/shapes.h"
#include "brindle/styled_picture.h"
#include "brindle/texture_animator.h"
#include "input/vertex_values.h"
#include "jobs/series_player.h"
#include "pictures/picture.h"
#include "pictures/style_values.h"
#include "pictures/styled_scene.h"

namespace brindle::tool {
namespace {

constexpr float kPointRadius = 0.014f;  // of the diagonal

/// A point of a frame.
struct Ball {
  Mesh mesh;
  std::vector<Vec3> normals;
};

Ball ball_at(const Vec3& middle, float radius, const Eigen::Vector3d& origin) {
  Ball ball{make_shape("sphere,resolution=12"), {}};
  ball.mesh.origin = origin;
  for (Vec3& position : ball.mesh.positions) {
    ball.normals.push_back(position.normalized());
    position = middle + radius * ball.normals.back();
  }
  return ball;
}

/// The values of frames. Those of files change from step to step, others with the shape. Ranges are
/// those of the first frame, so that colours keep their meaning.
class FrameValues {
 public:
  explicit FrameValues(const FrameStyle& style) : style_(style) {}

  StyleValues read(const FrameData& data, const Surface& surface, const Viewpoint& viewpoint) {
    return read_style_values(
        style_.style, [&](const std::string& option, const std::string& value) {
          VertexValues values =
              is_of_file(value) ? of_file(option, value, data, viewpoint)
                                : vertex_values(option, value, source(data, surface, viewpoint));
          if (!ends_.contains(option)) ends_[option] = values.range(option);
          values.ends = ends_[option];
          return values;
        });
  }

  /// Takes ranges from the next frame.
  void forget_ends() { ends_.clear(); }

 private:
  struct OfFile {
    std::size_t step = 0;
    VertexValues last, next;  ///< of the last step, and of the next one
  };

  ValueSource source(const FrameData& data, const Surface& surface,
                     const Viewpoint& viewpoint) const {
    return {surface, data.arrays, data.file, style_.waves.arrays, data.vertex_of_row, &viewpoint};
  }

  VertexValues of_file(const std::string& option, const std::string& value, const FrameData& data,
                       const Viewpoint& viewpoint) {
    const auto found = files_.find(option);
    if (found == files_.end() || found->second.step != data.step) {
      OfFile& values = files_[option];
      values.last = std::move(values.next);
      values.next = vertex_values(option, value, source(data, data.surface, viewpoint));
      values.step = data.step;
    }
    const OfFile& values = files_[option];
    VertexValues result = values.next;
    if (data.share == 1) return result;
    for (std::size_t v = 0; v < result.values.size(); ++v) {
      result.values[v] =
          (1 - data.share) * values.last.values[v] + data.share * values.next.values[v];
    }
    return result;
  }

  const FrameStyle& style_;
  std::map<std::string, Eigen::Vector2f> ends_;
  std::map<std::string, OfFile> files_;
};

AnimatorOptions without_slack(AnimatorOptions options) {
  options.slack = 0;  // already applied to the frequencies
  return options;
}

/// A texture that follows frames.
class FrameTexture {
 public:
  FrameTexture(const FrameStyle& style, float frequency_v)
      : style_(style), frequency_v_(frequency_v) {}

  const TextureWaves& frame(const Surface& surface, const WaveSet& waves) {
    if (!animator_ || triangles_ != surface.mesh.triangles) {
      animator_.emplace(surface, TextureAnimatorOptions{.oriented = style_.oriented,
                                                        .stripes = without_slack(style_.animator)});
      triangles_ = surface.mesh.triangles;
      whole_ = WholeTiles();
    }
    whole_ = whole_.of_next_texture(style_.whole_tiles);
    FrequencyField across;
    if (frequency_v_ > 0) across.assign(surface.mesh.vertex_count(), frequency_v_);
    return animator_
        ->frame({.u = {waves.positions, waves.directions, waves.frequencies},
                 .frequencies_v = across,
                 .normals = surface.normals})
        .pattern.waves;
  }

  /// Broken tiles of the last frame; valid while it is shown.
  std::span<const LeftOutTiles> broken(const TextureView& texture, const StyleBindings& followed) {
    broken_ = left_out_tiles(triangles_, texture, style_.style, followed, whole_);
    return broken_;
  }

  /// The shift after `frames` frames, in tiles.
  Eigen::Vector2f shift(std::size_t frames) const {
    const double seconds = static_cast<double>(frames) / style_.frames_per_second;
    const Eigen::Vector2d shift = style_.style.texture_shift.cast<double>() +
                                  seconds * style_.style.texture_flow.cast<double>();
    return (shift.array() - shift.array().floor()).matrix().cast<float>();
  }

 private:
  const FrameStyle& style_;
  float frequency_v_;  ///< 0: as along the field
  std::optional<TextureAnimator> animator_;
  std::vector<Triangle> triangles_;
  WholeTiles whole_;
  std::vector<LeftOutTiles> broken_;
};

class StyledFrames : public FramePainter {
 public:
  StyledFrames(const FrameStyle& style, const PictureOptions& picture)
      : style_(style),
        picture_(picture),
        values_(style),
        crossing_(without_slack(style.animator), style.match),
        viewpoint_(seen_viewpoint_of(picture)) {}

  Image paint(const SolvedFrame& frame) override;
  FrameNotes notes() const override { return notes_; }

 private:
  void begin(const SolvedFrame& frame, const Surface& surface);
  StyleBindings follow_frame(const SolvedFrame& frame, const Surface& surface);
  StyledScene scene_of(const SolvedFrame& frame, const Surface& surface,
                       const StyleBindings& followed);
  void show(const std::vector<StyledSurface>& surfaces, std::span<const Vec3> points);

  const FrameStyle& style_;
  const PictureOptions& picture_;
  FrameValues values_;
  SeriesAnimator crossing_;
  WaveSet across_;
  std::optional<FrameTexture> texture_;
  Viewpoint viewpoint_;
  std::vector<Vec3> framed_;
  std::vector<OtherSurface> others_;
  std::vector<std::optional<VertexValues>> other_values_;  ///< fixed, like the surfaces
  StyledRenderer renderer_;
  std::size_t uploaded_ = 0;  ///< surfaces and points
  std::size_t count_ = 0;
  FrameNotes notes_;
};

StyleBindings StyledFrames::follow_frame(const SolvedFrame& frame, const Surface& surface) {
  StyleValues values = values_.read(frame.data, surface, viewpoint_);
  values.others = other_values_;
  return follow(style_.style, values);
}

/// Prepares what is constant over all frames.
void StyledFrames::begin(const SolvedFrame& frame, const Surface& surface) {
  const StyleOptions& style = style_.style;
  const float diagonal = bounding_box(surface.mesh).diagonal();
  Viewpoint whole = viewpoint_of(picture_).value();
  whole.framed = surface.mesh;
  std::vector<Preparation> others =
      read_others(style, style_.waves, mean_frequency(frame.scene.waves), whole, style_.display);
  viewpoint_.framed = framed_mesh(surface.mesh, others);
  framed_ = points_of_triangles(*viewpoint_.framed);
  other_values_ = read_other_values(style, others, viewpoint_);
  StripeOptions stripes;
  stripes.phase_shift = style_.animator.phase_shift;
  others_ = solve_others(style, std::move(others), stripes, style_.display.progress());
  if (style.follows_camera()) {
    // The legend takes space, so that the camera moves back.
    viewpoint_.width -=
        legend_width(follow_frame(frame, surface).legends, viewpoint_.width, viewpoint_.height);
    values_.forget_ends();
  }
  if (!style_.tile) return;
  const WaveOptions& waves = style_.waves;
  const float of_stripes = waves.stripes_v ? frequency_of_stripes(*waves.stripes_v, diagonal) : 0;
  texture_.emplace(style_, waves.frequency_v.value_or(of_stripes));
}

StyledScene StyledFrames::scene_of(const SolvedFrame& frame, const Surface& surface,
                                   const StyleBindings& followed) {
  const WaveSet& waves = frame.scene.waves;
  StyledScene scene{surface, {waves, frame.z}, std::nullopt, others_, std::nullopt};
  if (texture_) {
    scene.texture.emplace(
        TextureView{texture_->frame(surface, waves), *style_.tile, texture_->shift(count_)});
    scene.texture->broken = texture_->broken(*scene.texture, followed);
    const LeftOutTiles& broken = scene.texture->broken.front();
    if (broken) notes_.few_tiles = tile_warning(*broken, surface.mesh.triangle_count());
  } else if (style_.style.cross_hatch) {
    across_ = waves_across(waves, surface.normals);
    const std::span<const DataArray> arrays =
        frame.data.share == 1 ? std::span(frame.data.arrays.points) : std::span<const DataArray>();
    const auto crossing = crossing_.frame({surface.mesh, surface.normals, across_, {}},
                                          surface.neighborhood, arrays, frame.data.file);
    scene.crossing.emplace(StripesView{across_, crossing.frame.z});
  }
  return scene;
}

/// Uploads only changes; other surfaces stay.
void StyledFrames::show(const std::vector<StyledSurface>& surfaces, std::span<const Vec3> points) {
  const Mesh& mesh = surfaces.front().mesh;
  const float radius = kPointRadius * bounding_box(*viewpoint_.framed).diagonal();
  std::vector<Ball> balls;
  for (const Vec3& point : points) balls.push_back(ball_at(point, radius, mesh.origin));
  std::vector<StyledSurface> all = surfaces;
  for (std::size_t k = 0; k < balls.size(); ++k) {
    all.push_back({.mesh = balls[k].mesh,
                   .normals = balls[k].normals,
                   .color = kPointColors[k % std::size(kPointColors)]});
  }
  if (uploaded_ != all.size()) {
    renderer_.upload(all);
    uploaded_ = all.size();
    return;
  }
  renderer_.update(0, all.front());
  for (std::size_t i = surfaces.size(); i < all.size(); ++i) renderer_.update(i, all[i]);
}

Image StyledFrames::paint(const SolvedFrame& frame) {
  const Surface surface{frame.scene.mesh, frame.data.surface.neighborhood, frame.scene.normals};
  if (count_ == 0) begin(frame, surface);
  StyleBindings followed = follow_frame(frame, surface);
  StyledOptions options = styled_options(style_.style, picture_, surface.mesh.origin, followed);
  if (style_.tile) name_tiles(style_.style, *style_.tile, options.render, followed);
  options.framed = framed_;
  const StyledScene scene = scene_of(frame, surface, followed);
  const std::vector<StyledSurface> surfaces =
      surfaces_of(scene, style_.style, options.render, followed);
  notes_.nothing_left = slice_refusal(surfaces, styled_camera(surfaces, options), "--slice");
  show(surfaces, frame.scene.points);
  Image image = renderer_.draw(options);
  draw_lines(image, scene, surfaces, style_.style, options, {});
  draw_legends(image, followed.legends);
  ++count_;
  return image;
}

}  // namespace

std::unique_ptr<FramePainter> make_styled_frames(const FrameStyle& style,
                                                 const PictureOptions& picture) {
  return std::make_unique<StyledFrames>(style, picture);
}

}  // namespace brindle::tool
