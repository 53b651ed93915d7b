#include "brindle/texture_animator.h"

#include <numbers>
#include <optional>
#include <string>
#include <utility>

#include "brindle/base/parallel.h"
#include "brindle/base/stopwatch.h"
#include "brindle/direction_field.h"
#include "brindle/error.h"
#include "brindle/pipeline/frames/animator_archive.h"
#include "brindle/pipeline/frames/frame_input.h"
#include "brindle/pipeline/measured_pattern.h"
#include "brindle/waves/wave_check.h"

namespace brindle {
namespace {

/// The waves of a frame's patterns.
struct NextWaves {
  WaveSet u, v;
};

FrameInput frame_input(const WaveSet& waves) {
  return {waves.positions, waves.directions, waves.frequencies};
}

void check_entries(std::size_t entries, std::size_t vertices, const char* what) {
  if (entries == 0 || entries == vertices) return;
  throw Error("texture animator: there are " + std::to_string(entries) + " " + what + " for " +
              std::to_string(vertices) + " vertices");
}

}  // namespace

struct TextureAnimator::State {
  State(const Surface& made_for, const TextureAnimatorOptions& made_with)
      : surface(made_for),
        options(made_with),
        orientation(surface.mesh.triangles),
        u(surface, options.stripes) {
    pattern.phase_shift = pattern.u.phase_shift = pattern.v.phase_shift =
        options.stripes.phase_shift;
    u.allow_take_back();
  }

  Surface surface;  ///< with the last frame's positions but the original normals
  TextureAnimatorOptions options;
  TextureOrientation orientation;
  StripeAnimator u;
  std::optional<StripeAnimator> v;  ///< created with the first frame; shares the topology of U
  std::vector<Complex> given_v;     ///< last phases of V for its first frame
  TexturePattern pattern;           ///< the last frame
  std::optional<BrokenTileFinder> finder;  ///< created on first use
  BrokenTiles broken;

  NextWaves checked_waves(const TextureFrameInput& input) const;
  TextureFrameResult solve(const NextWaves& next, const Progress& progress);
  void find_broken();
  void measure(TextureFrameResult& result);
};

/// Checks a frame's input and returns its waves.
NextWaves TextureAnimator::State::checked_waves(const TextureFrameInput& input) const {
  const std::size_t vertices = surface.mesh.vertex_count();
  check_frame_input(input.u, vertices);
  check_entries(input.frequencies_v.size(), vertices, "frequencies of V");
  check_entries(input.normals.size(), vertices, "normals");
  const auto& [positions, directions, frequencies, ignored] = input.u;
  NextWaves next;
  next.u = {{positions.begin(), positions.end()},
            {directions.begin(), directions.end()},
            {frequencies.begin(), frequencies.end()}};
  const std::span<const Vec3> normals = input.normals.empty() ? surface.normals : input.normals;
  check_tangent_waves(normals, next.u);
  next.v = next.u;
  next.v.directions = rotated(directions, normals, std::numbers::pi_v<float> / 2);
  if (!input.frequencies_v.empty()) {
    next.v.frequencies.assign(input.frequencies_v.begin(), input.frequencies_v.end());
  }
  check_waves(positions, next.v.directions, next.v.frequencies);
  for (const WaveSet* waves : {&next.u, &next.v}) {
    check_fineness(*surface.neighborhood, positions, waves->directions, waves->frequencies);
  }
  return next;
}

/// Solves both patterns and the orientation of the next frame; rolls all back on errors.
TextureFrameResult TextureAnimator::State::solve(const NextWaves& next, const Progress& progress) {
  TextureFrameResult result{pattern, {}, {}, {}, {}};
  JobStages stages(progress, {{"frame", 10}, {"texture", 2}});
  const Progress solving = stages.begin("frame");
  Stopwatch watch;
  result.u = u.solve(frame_input(next.u), solving.part(0, 0.5));
  const bool first = !v;
  bool has_v = false;
  try {
    if (first) {
      v.emplace(u.sibling());
      if (!given_v.empty()) v->set_last_phases(given_v);
    }
    result.v = v->solve(frame_input(next.v), solving.part(0.5, 1));
    has_v = true;
    result.milliseconds.solve = watch.lap();
    result.orientation = orientation.follow(next.u.directions, next.v.directions, options.oriented,
                                            stages.begin("texture"));
  } catch (...) {
    if (has_v) v->take_back(result.v);
    if (first) v.reset();
    u.take_back(result.u);
    throw;
  }
  result.milliseconds.orient = watch.lap();
  u.keep(frame_input(next.u), result.u);
  v->keep(frame_input(next.v), result.v);
  given_v.clear();
  result.milliseconds.solve += watch.lap();
  return result;
}

/// Uses the corner phases of vertex waves if textures are drawn by these waves.
void TextureAnimator::State::find_broken() {
  if (!finder) finder.emplace(surface.mesh.triangles);
  broken = pattern.phase_shift == PhaseShiftKind::aligned
               ? finder->find(pattern.u.corners, pattern.v.corners, orientation.signs(),
                              *options.whole_tiles)
               : finder->find(pattern.waves, *options.whole_tiles);
}

/// Finds broken tiles in parallel with the metrics, since it is a serial flood fill.
void TextureAnimator::State::measure(TextureFrameResult& result) {
  Stopwatch watch;
  const auto measure_patterns = [&] {
    set_quality(surface, options.stripes.slack.branch_penalty, pattern.u);
    set_quality(surface, options.stripes.slack.branch_penalty, pattern.v);
    pattern.quality = texture_quality(surface.mesh, pattern);
    result.milliseconds.measure += watch.lap();
  };
  if (!options.whole_tiles) return measure_patterns();
  parallel_both([&] { find_broken(); }, measure_patterns);
  result.broken = &broken;
  result.milliseconds.tiles = watch.lap();
}

TextureAnimator::TextureAnimator(const Surface& surface, const TextureAnimatorOptions& options) {
  if (surface.mesh.triangles.empty()) throw Error("textures need triangles; points have none");
  if (options.whole_tiles) check_tile_motifs(*options.whole_tiles);
  state_ = std::make_unique<State>(surface, options);
}

TextureAnimator::~TextureAnimator() = default;
TextureAnimator::TextureAnimator(TextureAnimator&&) noexcept = default;
TextureAnimator& TextureAnimator::operator=(TextureAnimator&&) noexcept = default;

TextureFrameResult TextureAnimator::frame(const TextureFrameInput& input,
                                          const Progress& progress) {
  State& s = *state_;
  NextWaves next = s.checked_waves(input);
  TextureFrameResult result = s.solve(next, progress);
  Stopwatch watch;
  const std::vector<Triangle>& triangles = s.surface.mesh.triangles;
  s.surface.mesh.positions = next.u.positions;
  set_frame(std::move(next.u), result.u, s.pattern.u);
  set_frame(std::move(next.v), result.v, s.pattern.v);
  set_oriented_waves(triangles, s.orientation, s.pattern);
  result.milliseconds.orient += watch.lap();
  set_corners(triangles, s.pattern.u);
  set_corners(triangles, s.pattern.v);
  result.milliseconds.measure = watch.lap();
  s.measure(result);
  s.pattern.orientation_milliseconds = result.milliseconds.orient + result.milliseconds.measure;
  return result;
}

double TextureAnimator::energy_u() const { return state_->u.energy(); }

double TextureAnimator::energy_v() const {
  if (!state_->v) throw Error("texture animator: there is no frame yet");
  return state_->v->energy();
}

void TextureAnimator::set_last_phases(std::span<const Complex> u, std::span<const Complex> v) {
  State& s = *state_;
  for (const std::span<const Complex> z : {u, v}) {
    check_last_phases(z, s.surface.mesh.vertex_count());
  }
  s.u.set_last_phases(u);
  if (s.v) {
    s.v->set_last_phases(v);
  } else {
    s.given_v.assign(v.begin(), v.end());
  }
}

void TextureAnimator::set_slack(const Slack& slack) {
  State& s = *state_;
  s.u.set_slack(slack);
  if (s.v) s.v->set_slack(slack);
  s.options.stripes.slack = slack;
}

void TextureAnimator::set_whole_tiles(const std::optional<TileMotifs>& motifs) {
  if (motifs) check_tile_motifs(*motifs);
  state_->options.whole_tiles = motifs;
}

void TextureAnimator::restart() {
  state_->orientation.forget();
  state_->given_v.clear();
  state_->u.restart();
  if (state_->v) state_->v->restart();
}

namespace {

void archive_tiles(Archive& archive, std::optional<TileMotifs>& tiles) {
  bool has = tiles.has_value();
  archive(has);
  if (!has) return;
  if (archive.reads()) tiles.emplace();
  archive.choice(tiles->layout, TileLayout::courses);
  for (Eigen::AlignedBox2f& extent : tiles->extents) archive(extent.min(), extent.max());
  archive(tiles->symmetries, tiles->shift, tiles->split);
}

}  // namespace

void AnimatorArchive::write(Archive& archive, const Surface& surface, TextureAnimator& animator) {
  TextureAnimator::State& s = *animator.state_;
  check_made_of(surface, *s.surface.neighborhood, s.surface.normals);
  bool slack = has_slack(s.u), has_v = s.v.has_value();
  archive(s.options.oriented, slack);
  archive_tiles(archive, s.options.whole_tiles);
  archive_options(archive, s.options.stripes);
  state(archive, s.u);
  archive(has_v, s.given_v);
  if (has_v) state(archive, *s.v);
  s.orientation.archive(archive, s.surface.mesh.vertex_count());
}

TextureAnimator AnimatorArchive::read_texture(Archive& archive, const Surface& surface) {
  TextureAnimatorOptions options;
  bool slack = false, has_v = false;
  archive(options.oriented, slack);
  archive_tiles(archive, options.whole_tiles);
  archive_options(archive, options.stripes);
  const Slack last_slack = options.stripes.slack;
  options.stripes = made_with(options.stripes, slack);
  TextureAnimator animator(surface, options);
  if (slack) animator.set_slack(last_slack);
  TextureAnimator::State& s = *animator.state_;
  state(archive, s.u);
  archive(has_v);
  archive.list_of_or_none(surface.mesh.vertex_count(), s.given_v);
  if (!s.given_v.empty()) check_last_phases(s.given_v, surface.mesh.vertex_count());
  if (has_v) state(archive, s.v.emplace(s.u.sibling()));
  s.orientation.archive(archive, surface.mesh.vertex_count());
  return animator;
}

}  // namespace brindle
