#include "brindle/texture_animator.h"

#include <algorithm>
#include <numbers>
#include <optional>
#include <string>
#include <utility>

#include "brindle/base/parallel.h"
#include "brindle/base/stopwatch.h"
#include "brindle/direction_field.h"
#include "brindle/error.h"
#include "brindle/pattern/texture_quality.h"
#include "brindle/pipeline/frames/frame_check.h"
#include "brindle/pipeline/frames/kept_orientation.h"
#include "brindle/pipeline/measured_pattern.h"
#include "brindle/stripe_pattern.h"
#include "brindle/waves/wave_check.h"

namespace brindle {
namespace {

/// The waves of a frame's patterns, and what V is orthogonal about.
struct NextWaves {
  WaveSet u, v;
  std::vector<Vec3> normals;  ///< empty: those of the surface
};

FrameInput frame_input(const WaveSet& waves, std::span<const Vec3> normals) {
  return {waves.positions, waves.directions, waves.frequencies, normals};
}

/// One pattern from frame to frame.
struct AnimatedPattern {
  StripeAnimator animator;
  WaveSet waves = {};                      ///< of the last frame, with the frequencies chosen
  FrequencyField frequencies_wanted = {};  ///< those asked for; empty without slack: the same
  std::vector<CornerPhases> corners = {};

  VertexWaves vertex_waves(std::span<const Complex> z) const {
    return {waves.positions, waves.directions, waves.frequencies, z};
  }
};

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
        orientation(made_for.mesh.triangles),
        u{StripeAnimator(made_for, made_with.stripes)} {
    u.animator.allow_take_back();
  }

  Surface surface;  ///< at the place of the last frame, but for the normals, which stay
  TextureAnimatorOptions options;
  KeptOrientation orientation;
  AnimatedPattern u;
  std::optional<AnimatedPattern> v;  ///< after the first frame of U, whose topology it shares
  std::vector<Complex> given_v;      ///< last phases of V for its first frame
  TextureWaves waves;
  std::optional<BrokenTileFinder> finder;  ///< once somebody has asked
  BrokenTiles broken;

  void find_broken();

  NextWaves checked_waves(const TextureFrameInput& input) const;
  TextureFrameResult solve(NextWaves& next, const Progress& progress);
  void take_waves(AnimatedPattern& pattern, WaveSet& next, const FrameResult& stripes) const;
  void lift(AnimatedPattern& pattern, const FrameResult& stripes) const;
  PatternQuality measured(AnimatedPattern& pattern) const;
  void measure(TextureFrameResult& result);
};

/// From the corner phases of the vertices' own waves, if those are what textures are drawn by.
void TextureAnimator::State::find_broken() {
  if (!finder) finder.emplace(surface.mesh.triangles);
  broken = options.stripes.phase_shift == PhaseShiftKind::aligned
               ? finder->find(u.corners, v->corners, orientation.signs(), *options.whole_tiles)
               : finder->find(waves, *options.whole_tiles);
}

/// The waves of a frame, if everything about them is right.
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
  next.normals.assign(input.normals.begin(), input.normals.end());
  const std::span<const Vec3> normals = next.normals.empty() ? surface.normals : next.normals;
  check_tangent_waves(normals, next.u);
  if (!input.frequencies_v.empty()) check_waves(positions, directions, input.frequencies_v);
  next.v = next.u;
  next.v.directions = rotated(next.u.directions, normals, std::numbers::pi_v<float> / 2);
  if (!input.frequencies_v.empty()) {
    next.v.frequencies.assign(input.frequencies_v.begin(), input.frequencies_v.end());
  }
  return next;
}

/// Both patterns and the orientation of the next frame, or none of them.
TextureFrameResult TextureAnimator::State::solve(NextWaves& next, const Progress& progress) {
  TextureFrameResult result{{}, {}, waves, {}, {}, {}, {}};
  const std::span<const Vec3> normals = next.normals.empty() ? surface.normals : next.normals;
  const FrameInput input_u = frame_input(next.u, normals), input_v = frame_input(next.v, normals);
  JobStages stages(progress, {{"frame", 10}, {"texture", 2}});
  const Progress solving = stages.begin("frame");
  Stopwatch watch;
  FrameResult& stripes_u = result.u.stripes;
  FrameResult& stripes_v = result.v.stripes;
  stripes_u = u.animator.solve(input_u, solving.part(0, 0.5));
  const bool first = !v;
  bool has_v = false;
  try {
    if (first) {
      v = AnimatedPattern{u.animator.sibling()};
      if (!given_v.empty()) v->animator.set_last_phases(given_v);
    }
    stripes_v = v->animator.solve(input_v, solving.part(0.5, 1));
    has_v = true;
    result.milliseconds.solve = watch.lap();
    result.orientation = orientation.follow(next.u.directions, next.v.directions, options.oriented,
                                            stages.begin("texture"));
  } catch (...) {
    if (has_v) v->animator.take_back(stripes_v);
    if (first) v.reset();
    u.animator.take_back(stripes_u);
    throw;
  }
  result.milliseconds.orient = watch.lap();
  u.animator.keep(input_u, stripes_u);
  v->animator.keep(input_v, stripes_v);
  given_v.clear();
  result.milliseconds.solve += watch.lap();
  return result;
}

void TextureAnimator::State::take_waves(AnimatedPattern& pattern, WaveSet& next,
                                        const FrameResult& stripes) const {
  pattern.waves = std::move(next);
  const std::span<const float> chosen = stripes.frequencies;
  if (chosen.empty()) return;
  pattern.frequencies_wanted = std::move(pattern.waves.frequencies);
  pattern.waves.frequencies.assign(chosen.begin(), chosen.end());
}

void TextureAnimator::State::lift(AnimatedPattern& pattern, const FrameResult& stripes) const {
  pattern.corners.resize(surface.mesh.triangle_count());
  fill_corner_phases(surface.mesh.triangles, pattern.waves, stripes.z, options.stripes.phase_shift,
                     pattern.corners);
}

PatternQuality TextureAnimator::State::measured(AnimatedPattern& pattern) const {
  WaveSet& waves_now = pattern.waves;
  PatternQuality quality = measure_quality(surface.mesh, waves_now, pattern.corners);
  quality.spacing_error_wanted_mean = quality.spacing_error_mean;
  if (!pattern.frequencies_wanted.empty()) {
    std::swap(waves_now.frequencies, pattern.frequencies_wanted);
    quality.spacing_error_wanted_mean =
        measure_quality(surface.mesh, waves_now, pattern.corners).spacing_error_mean;
    std::swap(waves_now.frequencies, pattern.frequencies_wanted);
  }
  const std::vector<float>& calm = options.stripes.slack.calm;
  if (!calm.empty()) {
    quality.branches_in_calm = count_in_calm(surface.mesh.triangles, pattern.corners, calm);
  }
  return quality;
}

/// What is known of the frame's patterns. Figures that are broken are found at the same time: they
/// are passed on from triangle to triangle by one thread.
void TextureAnimator::State::measure(TextureFrameResult& result) {
  Stopwatch watch;
  const auto measure_patterns = [&] {
    result.u.quality = measured(u);
    result.v.quality = measured(*v);
    result.quality = measure_texture(surface.mesh, {u.corners, u.waves.frequencies},
                                     {v->corners, v->waves.frequencies});
    result.milliseconds.measure = watch.lap();
  };
  if (!options.whole_tiles) return measure_patterns();
  parallel_both([&] { find_broken(); }, measure_patterns);
  result.broken = &broken;
  result.milliseconds.tiles = watch.lap();
}

TextureAnimator::TextureAnimator(const Surface& surface, const TextureAnimatorOptions& options) {
  if (surface.mesh.triangles.empty()) throw Error("textures need triangles; points have none");
  if (options.whole_tiles) check_tile_figures(*options.whole_tiles);
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
  s.surface.mesh.positions = next.u.positions;
  const FrameResult u = result.u.stripes, v = result.v.stripes;
  s.take_waves(s.u, next.u, u);
  s.take_waves(*s.v, next.v, v);
  result.seams = s.orientation.seams();
  set_texture_waves(s.surface.mesh.triangles, s.orientation.signs(), s.u.vertex_waves(u.z),
                    s.v->vertex_waves(v.z), s.waves);
  result.milliseconds.orient += watch.lap();

  s.lift(s.u, u);
  s.lift(*s.v, v);
  result.u.corners = s.u.corners;
  result.v.corners = s.v->corners;
  const double lifting = watch.lap();
  s.measure(result);
  result.milliseconds.measure += lifting;
  return result;
}

double TextureAnimator::energy_u() const { return state_->u.animator.energy(); }

double TextureAnimator::energy_v() const {
  if (!state_->v) throw Error("texture animator: there is no frame yet");
  return state_->v->animator.energy();
}

void TextureAnimator::set_last_phases(std::span<const Complex> u, std::span<const Complex> v) {
  State& s = *state_;
  for (const std::span<const Complex> z : {u, v}) {
    check_last_phases(z, s.surface.mesh.vertex_count());
  }
  s.u.animator.set_last_phases(u);
  if (s.v) {
    s.v->animator.set_last_phases(v);
  } else {
    s.given_v.assign(v.begin(), v.end());
  }
}

void TextureAnimator::set_slack(const Slack& slack) {
  State& s = *state_;
  s.u.animator.set_slack(slack);
  if (s.v) s.v->animator.set_slack(slack);
  s.options.stripes.slack = slack;
}

void TextureAnimator::set_whole_tiles(const std::optional<TileFigures>& figures) {
  if (figures) check_tile_figures(*figures);
  state_->options.whole_tiles = figures;
}

void TextureAnimator::restart() {
  state_->orientation.forget();
  state_->given_v.clear();
  state_->u.animator.restart();
  if (state_->v) state_->v->animator.restart();
}

}  // namespace brindle
