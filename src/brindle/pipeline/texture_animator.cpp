#include "brindle/texture_animator.h"

#include <algorithm>
#include <numbers>
#include <optional>
#include <string>
#include <utility>

#include "brindle/base/stopwatch.h"
#include "brindle/direction_field.h"
#include "brindle/error.h"
#include "brindle/pattern/texture_quality.h"
#include "brindle/pipeline/kept_orientation.h"
#include "brindle/stripe_pattern.h"
#include "brindle/waves/wave_check.h"

namespace brindle {
namespace {

/// One pattern from frame to frame.
struct AnimatedPattern {
  StripeAnimator animator;
  WaveSet waves;  ///< of the last frame
  std::vector<CornerPhases> corners;

  FrameInput input() const { return {waves.positions, waves.directions, waves.frequencies}; }
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
        u{StripeAnimator(made_for.neighborhood, made_with.stripes), {}, {}} {}

  Surface surface;  ///< at the place of the last frame
  TextureAnimatorOptions options;
  KeptOrientation orientation;
  AnimatedPattern u;
  std::optional<AnimatedPattern> v;  ///< after the first frame of U, whose topology it shares
  TextureWaves waves;

  WaveSet checked_waves(const TextureFrameInput& input) const;
  TexturePatternFrame measured(AnimatedPattern& pattern, const FrameResult& stripes) const;
};

/// U of a frame, if everything about it is right.
WaveSet TextureAnimator::State::checked_waves(const TextureFrameInput& input) const {
  const std::size_t vertices = surface.mesh.vertex_count();
  check(input.u, vertices);
  check_entries(input.frequencies_v.size(), vertices, "frequencies of V");
  check_entries(input.normals.size(), vertices, "normals");
  const auto& [positions, directions, frequencies] = input.u;
  WaveSet result{{positions.begin(), positions.end()},
                 {directions.begin(), directions.end()},
                 {frequencies.begin(), frequencies.end()}};
  check_tangent_waves(
      input.normals.empty() ? std::span<const Vec3>(surface.normals) : input.normals, result);
  if (!input.frequencies_v.empty()) check_waves(positions, directions, input.frequencies_v);
  return result;
}

TexturePatternFrame TextureAnimator::State::measured(AnimatedPattern& pattern,
                                                     const FrameResult& stripes) const {
  const PhaseShiftKind kind = options.stripes.phase_shift;
  pattern.corners = corner_phases(surface.mesh.triangles, pattern.waves, stripes.z, kind);
  return {stripes, pattern.corners, measure_quality(surface.mesh, pattern.waves, pattern.corners)};
}

TextureAnimator::TextureAnimator(const Surface& surface, const TextureAnimatorOptions& options) {
  if (surface.mesh.triangles.empty()) throw Error("textures need triangles; points have none");
  state_ = std::make_unique<State>(surface, options);
}

TextureAnimator::~TextureAnimator() = default;
TextureAnimator::TextureAnimator(TextureAnimator&&) noexcept = default;
TextureAnimator& TextureAnimator::operator=(TextureAnimator&&) noexcept = default;

TextureFrameResult TextureAnimator::frame(const TextureFrameInput& input) {
  State& s = *state_;
  WaveSet waves_u = s.checked_waves(input);
  WaveSet waves_v = waves_u;
  if (!input.normals.empty()) s.surface.normals.assign(input.normals.begin(), input.normals.end());
  waves_v.directions =
      rotated(waves_u.directions, s.surface.normals, std::numbers::pi_v<float> / 2);
  if (!input.frequencies_v.empty()) {
    waves_v.frequencies.assign(input.frequencies_v.begin(), input.frequencies_v.end());
  }
  s.surface.mesh.positions = waves_u.positions;

  Stopwatch watch;
  s.u.waves = std::move(waves_u);
  const FrameResult u = s.u.animator.frame(s.u.input());
  if (!s.v) s.v = {s.u.animator.sibling(), {}, {}};
  s.v->waves = std::move(waves_v);
  const FrameResult v = s.v->animator.frame(s.v->input());
  TextureFrameResult result{{}, {}, s.waves, {}, {}, {}, {}};
  result.milliseconds.solve = watch.lap();

  result.orientation =
      s.orientation.follow(s.u.waves.directions, s.v->waves.directions, s.options.oriented);
  result.seams = s.orientation.seams();
  set_texture_waves(s.surface.mesh.triangles, s.orientation.signs(), s.u.vertex_waves(u.z),
                    s.v->vertex_waves(v.z), s.waves);
  result.milliseconds.orient = watch.lap();

  result.u = s.measured(s.u, u);
  result.v = s.measured(*s.v, v);
  result.quality = measure_texture(s.surface.mesh, {s.u.corners, s.u.waves.frequencies},
                                   {s.v->corners, s.v->waves.frequencies});
  result.milliseconds.measure = watch.lap();
  return result;
}

double TextureAnimator::energy_u() const { return state_->u.animator.energy(); }

double TextureAnimator::energy_v() const {
  if (!state_->v) throw Error("texture animator: there is no frame yet");
  return state_->v->animator.energy();
}

void TextureAnimator::restart() {
  state_->orientation.forget();
  state_->u.animator.restart();
  if (state_->v) state_->v->animator.restart();
}

}  // namespace brindle
