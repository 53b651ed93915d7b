#include "brindle/cross_animator.h"

#include <cmath>
#include <optional>
#include <string>
#include <utility>

#include <Eigen/Geometry>

#include "brindle/base/parallel.h"
#include "brindle/base/stopwatch.h"
#include "brindle/carried_phases.h"
#include "brindle/cross_texture.h"
#include "brindle/error.h"
#include "brindle/pattern/quality_sums.h"
#include "brindle/pipeline/cross_parts.h"
#include "brindle/pipeline/frames/animator_archive.h"
#include "brindle/pipeline/frames/frame_input.h"
#include "brindle/stripe_pattern.h"
#include "brindle/waves/wave_check.h"

namespace brindle {
namespace {

/// Keeps the numbering of wave 0 and 1 from the last frame, since any direction of a cross may be
/// given.
void match_previous_axes(const WaveSet& last, WaveSet& crosses) {
  parallel_for(crosses.directions.size() / 2, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      Vec3& first = crosses.directions[2 * i];
      Vec3& second = crosses.directions[2 * i + 1];
      const Vec3& before = last.directions[2 * i];
      if (std::abs(before.dot(second)) <= std::abs(before.dot(first))) continue;
      std::swap(first, second);
      second = -second;
    }
  });
}

/// Weights on the cover: both nodes of a vertex have its edges in the same order.
std::vector<float> weights_on_cover(const Adjacency& neighborhood, std::span<const float> weights) {
  std::vector<float> result;
  if (weights.empty()) return result;
  result.reserve(2 * weights.size());
  for (Index i = 0; i < neighborhood.node_count(); ++i) {
    const auto row = weights.subspan(neighborhood.offsets[i],
                                     neighborhood.offsets[i + 1] - neighborhood.offsets[i]);
    for (int wave = 0; wave < 2; ++wave) result.insert(result.end(), row.begin(), row.end());
  }
  return result;
}

/// Frequencies of waves (i, r). Vertices added behind the surface's own have no wave.
FrequencyField frequencies_of(const CrossCover& cover, std::size_t r, std::size_t vertices) {
  const FrequencyField& nodes = cover.waves.frequencies;
  FrequencyField result(vertices, nodes.front());
  for (std::size_t i = 0; 2 * i < nodes.size(); ++i) result[i] = nodes[2 * i + r];
  return result;
}

FrameInput cover_input(const WaveSet& waves, std::span<const Vec3> normals) {
  return {waves.positions, waves.directions, waves.frequencies, normals};
}

/// Whether the cover fits the mesh, apart from how crosses match.
bool is_cover_of(const CrossCover& cover, const Mesh& mesh) {
  const std::size_t nodes = 2 * mesh.vertex_count(), matched = cover.base.size();
  const WaveSet& waves = cover.waves;
  if (waves.positions.size() != nodes || waves.directions.size() != nodes ||
      waves.frequencies.size() != nodes || cover.triangles.size() != 2 * matched ||
      matched + cover.singular.size() != mesh.triangle_count()) {
    return false;
  }
  for (std::size_t n = 0; n < cover.triangles.size(); ++n) {
    const Index base = cover.base[n % matched];
    if (base >= mesh.triangle_count()) return false;
    for (std::size_t c = 0; c < 3; ++c) {
      if (cover.triangles[n][c] / 2 != mesh.triangles[base][c]) return false;
    }
  }
  return true;
}

/// Result of a frame.
struct CrossFrameState {
  CrossCover cover = {};
  Mesh cover_mesh = {};  ///< positions and triangles of the cover
  std::vector<Complex> z = {};
  CrossParts parts = {};

  void take(const FrameResult& stripes);
};

/// Takes over a frame's phases and the frequencies that they belong to.
void CrossFrameState::take(const FrameResult& stripes) {
  cover_mesh.positions = cover.waves.positions;
  if (!stripes.frequencies.empty()) {
    cover.waves.frequencies.assign(stripes.frequencies.begin(), stripes.frequencies.end());
  }
  z.assign(stripes.z.begin(), stripes.z.end());
}

void measure(const CrossFrameState& laid, PhaseShiftKind kind, const Progress& progress,
             CrossFrameResult& result) {
  const auto& [cover, cover_mesh, z, parts] = laid;
  const auto corners = corner_phases(cover.triangles, cover.waves, z, kind, progress.part(0, 0.3));
  result.quality = cross_quality(
      cover, measure_quality(cover_mesh, cover.waves, corners, progress.part(0.3, 0.6)), corners);
  // Texture triangles: those of the cover, which may be reversed, then the parts of singular ones.
  const std::size_t pairs = cover.base.size();
  const auto behind = [&](std::span<const CornerPhases> first,
                          const std::vector<CornerWaves>& all) {
    std::vector<CornerPhases> phases;
    phases.reserve(all.size());
    phases.assign(first.begin(), first.end());
    for (const CornerPhases& part : corner_phases(std::span(all).subspan(pairs), kind)) {
      phases.push_back(part);
      phases.back().kind = TriangleKind::field_singularity;
    }
    return phases;
  };
  progress.tick();
  const auto u = behind(std::span(corners).first(pairs), parts.waves.u);
  const auto v = behind(std::span(corners).last(pairs), parts.waves.v);
  const auto frequencies_u = frequencies_of(cover, 0, parts.mesh.vertex_count());
  const auto frequencies_v = frequencies_of(cover, 1, parts.mesh.vertex_count());
  result.texture =
      measure_texture(parts.mesh, {u, frequencies_u}, {v, frequencies_v}, progress.part(0.7, 1));
}

}  // namespace

struct CrossAnimator::State {
  Surface surface;  ///< with the last frame's positions but the original normals
  AnimatorOptions options;
  AnimatorOptions on_cover = {};
  bool made_with_slack = false;

  std::optional<StripeAnimator> animator = {};  ///< of the cover; none before the first frame
  CrossFrameState laid = {};                    ///< the last frame

  WaveSet checked_waves(const CrossFrameInput& input) const;
  std::span<const Vec3> normals_of(const CrossFrameInput& input) const {
    return input.normals.empty() ? std::span<const Vec3>(surface.normals) : input.normals;
  }
  std::vector<Vec3> normals_on_cover(const CrossFrameInput& input) const;
  StripeAnimator animator_of(const CrossCover& made, std::span<const Vec3> normals) const;
  void solve_again(WaveSet crosses, const CrossFrameInput& input, const Progress& progress,
                   CrossFrameResult& result);
  void solve_from_scratch(WaveSet crosses, const CrossFrameInput& input, const Progress& progress,
                          CrossFrameResult& result);
  void lay(const Mesh& placed, CrossFrameState& next, const Progress& progress,
           CrossFrameResult& result) const;
};

WaveSet CrossAnimator::State::checked_waves(const CrossFrameInput& input) const {
  const std::size_t vertices = surface.mesh.vertex_count();
  check_frame_input(input.waves, vertices);
  if (!input.normals.empty() && input.normals.size() != vertices) {
    throw Error("cross animator: there are " + std::to_string(input.normals.size()) +
                " normals for " + std::to_string(vertices) + " vertices");
  }
  const FrameInput& given = input.waves;
  WaveSet waves{{given.positions.begin(), given.positions.end()},
                {given.directions.begin(), given.directions.end()},
                {given.frequencies.begin(), given.frequencies.end()}};
  check_tangent_waves(normals_of(input), waves);
  return waves;
}

/// Normals of the cover, which only the frequency relaxation needs.
std::vector<Vec3> CrossAnimator::State::normals_on_cover(const CrossFrameInput& input) const {
  std::vector<Vec3> result;
  if (!made_with_slack) return result;
  for (const Vec3& normal : normals_of(input)) result.insert(result.end(), 2, normal);
  return result;
}

/// A new animator that continues from the last frame's phases, if any.
StripeAnimator CrossAnimator::State::animator_of(const CrossCover& made,
                                                 std::span<const Vec3> normals) const {
  StripeAnimator result = on_cover.slack.relaxes()
                              ? StripeAnimator(cover_surface(made, normals), on_cover)
                              : StripeAnimator(made.neighborhood, on_cover);
  if (!laid.z.empty()) {
    result.set_last_phases(matched_phases({laid.cover_mesh, laid.cover.waves, laid.z}, made.waves));
  }
  return result;
}

CrossAnimator::CrossAnimator(const Surface& surface, const AnimatorOptions& options) {
  check_animator_options(options);
  check_slack(options.slack, surface.mesh.vertex_count());
  if (surface.mesh.triangles.empty()) throw Error("cross fields need triangles; points have none");
  state_ = std::make_unique<State>(State{surface, options});
  state_->on_cover = options;
  state_->on_cover.slack = slack_on_cover(options.slack);
  state_->made_with_slack = options.slack.relaxes();
  state_->on_cover.edge_weights = weights_on_cover(*surface.neighborhood, options.edge_weights);
}

CrossAnimator::~CrossAnimator() = default;
CrossAnimator::CrossAnimator(CrossAnimator&&) noexcept = default;
CrossAnimator& CrossAnimator::operator=(CrossAnimator&&) noexcept = default;

/// Builds and measures the triangles of a frame with known phases.
void CrossAnimator::State::lay(const Mesh& placed, CrossFrameState& next, const Progress& progress,
                               CrossFrameResult& result) const {
  Stopwatch watch;
  next.parts = cross_parts(placed, next.cover, next.z, options.phase_shift, std::move(next.parts),
                           progress.part(0, 0.5));
  result.milliseconds.orient = watch.lap();
  measure(next, options.phase_shift, progress.part(0.5, 1), result);
  result.milliseconds.measure = watch.lap();
}

/// Crosses match as in the last frame, whose memory is reused. Once phases are known, the frame
/// replaces the last one and can no longer be cancelled.
void CrossAnimator::State::solve_again(WaveSet crosses, const CrossFrameInput& input,
                                       const Progress& progress, CrossFrameResult& result) {
  Stopwatch watch;
  result.matching = CrossMatching::kept;
  result.stripes = animator->frame(cover_input(crosses, normals_on_cover(input)), progress);
  laid.cover.waves = std::move(crosses);
  laid.take(result.stripes);
  result.milliseconds.solve = watch.lap();
  surface.mesh.positions.assign(input.waves.positions.begin(), input.waves.positions.end());
  lay(surface.mesh, laid, {}, result);
}

/// Crosses match differently, or there is no last frame. The result is built separately, so that
/// cancelling keeps the last frame.
void CrossAnimator::State::solve_from_scratch(WaveSet crosses, const CrossFrameInput& input,
                                              const Progress& progress, CrossFrameResult& result) {
  JobStages stages(progress, {{"match crosses", 2}, {"frame", 10}, {"texture", 4}});
  Stopwatch watch;
  result.matching = animator ? CrossMatching::renewed : CrossMatching::afresh;
  const Progress matching = stages.begin("match crosses");
  CrossFrameState next;
  next.cover = cross_cover(*surface.neighborhood, surface.mesh.triangles, std::move(crosses),
                           matching.part(0, 0.8));
  StripeAnimator first = animator_of(next.cover, normals_of(input));
  result.milliseconds.match += watch.lap();
  const WaveSet& waves = next.cover.waves;
  result.stripes = first.frame(cover_input(waves, normals_on_cover(input)), stages.begin("frame"));
  const Progress texturing = stages.begin("texture");
  next.cover_mesh.triangles = next.cover.triangles;
  next.take(result.stripes);
  result.milliseconds.solve = watch.lap();
  Mesh placed = surface.mesh;
  placed.positions.assign(input.waves.positions.begin(), input.waves.positions.end());
  lay(placed, next, texturing, result);
  stages.finish();
  animator = std::move(first);
  laid = std::move(next);
  surface.mesh.positions = std::move(placed.positions);
}

CrossFrameResult CrossAnimator::frame(const CrossFrameInput& input, const Progress& progress) {
  State& s = *state_;
  const WaveSet waves = s.checked_waves(input);
  CrossFrameResult result{{}, s.laid.cover, s.laid.parts.mesh, s.laid.parts.waves, {}, {}, {}, {}};
  Stopwatch watch;
  WaveSet crosses = cross_waves(waves, s.normals_of(input));
  if (s.animator) match_previous_axes(s.laid.cover.waves, crosses);
  const bool kept = s.animator && are_matched_alike(*s.surface.neighborhood, crosses, s.laid.cover);
  result.milliseconds.match = watch.lap();
  if (kept) {
    s.solve_again(std::move(crosses), input, progress, result);
  } else {
    s.solve_from_scratch(std::move(crosses), input, progress, result);
  }
  return result;
}

double CrossAnimator::energy() const {
  if (!state_->animator) throw Error("cross animator: there is no frame yet");
  return state_->animator->energy();
}

void CrossAnimator::set_last_phases(const CrossCover& cover, std::span<const Complex> z) {
  State& s = *state_;
  const std::size_t nodes = 2 * s.surface.mesh.vertex_count();
  if (cover.waves.directions.size() != nodes) {
    throw Error("cross animator: the cover is of " +
                std::to_string(cover.waves.directions.size() / 2) + " vertices; the surface has " +
                std::to_string(nodes / 2));
  }
  if (!is_cover_of(cover, s.surface.mesh)) {
    throw Error("cross animator: the cover is of another surface, or incomplete");
  }
  check_last_phases(z, nodes);
  CrossFrameState last;
  last.cover = cover;
  last.cover_mesh.triangles = cover.triangles;
  last.cover_mesh.positions = cover.waves.positions;
  last.z.assign(z.begin(), z.end());
  s.laid = std::move(last);
  s.animator.reset();
}

void CrossAnimator::set_slack(const Slack& slack) {
  State& s = *state_;
  check_slack(slack, s.surface.mesh.vertex_count());
  check_made_with_slack(s.made_with_slack);
  Slack of_cover = slack_on_cover(slack);
  // An animator built without slack cannot take one: create another one for the next frame.
  if (s.animator && !s.on_cover.slack.relaxes()) s.animator.reset();
  if (s.animator) s.animator->set_slack(of_cover);
  s.on_cover.slack = std::move(of_cover);
  s.options.slack = slack;
}

void CrossAnimator::restart() {
  state_->animator.reset();
  state_->laid.z.clear();
}

namespace {

/// Waves and phases of the last frame. The cover follows from the waves.
void archive_last(Archive& archive, std::size_t nodes, CrossFrameState& last) {
  archive_waves(archive, nodes, last.cover.waves);
  archive.list_of_or_none(nodes, last.z);
  if (!last.z.empty()) check_last_phases(last.z, nodes);
}

}  // namespace

void AnimatorArchive::write(Archive& archive, const Surface& surface, CrossAnimator& animator) {
  CrossAnimator::State& s = *animator.state_;
  check_made_of(surface, *s.surface.neighborhood, s.surface.normals);
  bool has_last = !s.laid.cover.waves.directions.empty(), has_animator = s.animator.has_value();
  bool slack = has_animator && has_slack(*s.animator);
  archive(s.made_with_slack, has_last, has_animator, slack);
  archive_options(archive, s.options);
  if (has_last) archive_last(archive, 2 * surface.mesh.vertex_count(), s.laid);
  if (has_animator) state(archive, *s.animator);
}

CrossAnimator AnimatorArchive::read_crosses(Archive& archive, const Surface& surface) {
  bool made_with_slack = false, has_last = false, has_animator = false, slack = false;
  AnimatorOptions options;
  archive(made_with_slack, has_last, has_animator, slack);
  archive_options(archive, options);
  if ((has_animator && !has_last) || (slack && !made_with_slack)) Archive::fail();
  CrossAnimator animator(surface, made_with(options, made_with_slack));
  if (made_with_slack) animator.set_slack(options.slack);
  CrossAnimator::State& s = *animator.state_;
  if (has_last) {
    archive_last(archive, 2 * surface.mesh.vertex_count(), s.laid);
    s.laid.cover =
        cross_cover(*surface.neighborhood, surface.mesh.triangles, std::move(s.laid.cover.waves));
    s.laid.cover_mesh.triangles = s.laid.cover.triangles;
    s.laid.cover_mesh.positions = s.laid.cover.waves.positions;
  }
  if (!has_animator) return animator;
  const AnimatorOptions on_cover = made_with(without_slack(s.on_cover), slack);
  s.animator.emplace(slack ? StripeAnimator(cover_surface(s.laid.cover, surface.normals), on_cover)
                           : StripeAnimator(s.laid.cover.neighborhood, on_cover));
  if (slack) s.animator->set_slack(s.on_cover.slack);
  state(archive, *s.animator);
  return animator;
}

}  // namespace brindle
