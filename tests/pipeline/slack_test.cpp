// Patterns and frames whose frequencies yield.
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "brindle/cross_texture.h"
#include "brindle/error.h"
#include "brindle/files.h"
#include "brindle/points.h"
#include "brindle/smooth_field.h"
#include "brindle/stripe_animator.h"
#include "brindle/stripe_pattern.h"
#include "brindle/texture_pattern.h"
#include "phase_graphs.h"
#include "progress_reports.h"
#include "test_meshes.h"

namespace brindle {
namespace {

using testing_support::kAxis;
using testing_support::Reports;
using testing_support::wavy_surface;
using testing_support::WavySurface;

Surface surface_with(const WavySurface& s) { return {s.mesh, s.neighborhood, s.normals}; }

StripeOptions with_slack(const Slack& slack) {
  StripeOptions options;
  options.slack = slack;
  return options;
}

std::size_t spare_branches(const StripePattern& pattern) {
  return pattern.quality.branches - pattern.quality.field_singularities;
}

/// 3 % and, where there are few branches, a pair of them.
double no_more_than(std::size_t branches) {
  return std::max(1.03 * static_cast<double>(branches), static_cast<double>(branches + 2));
}

/// Without slack, and with a quarter.
struct SpareBranches {
  std::size_t plain, yielded;
};

SpareBranches expect_fewer_branches(const Surface& surface, const DirectionField& field,
                                    float stripes,
                                    const std::vector<float>& slacks = {0.05f, 0.1f, 0.25f, 0.5f},
                                    double share = 0.6) {
  const float frequency = frequency_of_stripes(stripes, bounding_box(surface.mesh).diagonal());
  const StripePattern plain = stripe_pattern(surface, field, frequency);
  SpareBranches spare{spare_branches(plain), 0};
  std::size_t last = plain.quality.branches;
  for (const float slack : slacks) {
    const StripePattern yielded = stripe_pattern(surface, field, frequency, with_slack(slack));
    EXPECT_LE(static_cast<double>(yielded.quality.branches), no_more_than(last)) << slack;
    EXPECT_LT(yielded.solution.energy, plain.solution.energy) << slack;
    last = yielded.quality.branches;
    if (slack != 0.25f) continue;
    spare.yielded = spare_branches(yielded);
    // A pair more or less is a matter of rounding.
    EXPECT_LE(static_cast<double>(spare.yielded), share * static_cast<double>(spare.plain) + 2);
    EXPECT_LT(yielded.quality.angle_error_mean_deg, plain.quality.angle_error_mean_deg);
  }
  return spare;
}

TEST(SlackTest, LeavesFewerBranchesAlongADirection) {
  const Surface surface = make_surface(make_shape("trefoil"));
  for (const float stripes : {40.0f, 100.0f}) {
    SCOPED_TRACE(stripes);
    expect_fewer_branches(surface, projected_direction_field(kAxis, surface.normals), stripes);
  }
}

TEST(SlackTest, LeavesFewerBranchesAlongTurnedCurvature) {
  const Surface surface = make_surface(make_shape("trefoil"));
  SmoothFieldOptions smooth;
  smooth.curvature_anchor = 0.1f;
  const DirectionField field =
      rotated(smooth_direction_field(surface, smooth), surface.normals, 0.6108652f);
  for (const float stripes : {40.0f, 100.0f}) {
    SCOPED_TRACE(stripes);
    expect_fewer_branches(surface, field, stripes);
  }
}

TEST(SlackTest, LeavesFewerBranchesAlongSmoothFields) {
  for (const char* shape : {"vessels", "box"}) {
    const Surface surface = make_surface(make_shape(shape));
    for (const float stripes : {40.0f, 100.0f}) {
      SCOPED_TRACE(std::string(shape) + " " + std::to_string(stripes));
      expect_fewer_branches(surface, smooth_direction_field(surface), stripes);
    }
  }
}

TEST(SlackTest, LeavesHalfAsManyBranchesOnModels) {
  SpareBranches all{0, 0};
  for (const char* model : {"horse.ply", "nefertiti.obj", "spot.obj", "stanford-bunny.obj"}) {
    const auto path = std::filesystem::path(BRINDLE_SHARED_MODELS) / model;
    if (!std::filesystem::exists(path)) GTEST_SKIP() << path << " is not there";
    const Surface surface = make_surface(read_mesh(path).mesh);
    for (const float stripes : {40.0f, 100.0f}) {
      SCOPED_TRACE(std::string(model) + " " + std::to_string(stripes));
      const SpareBranches spare = expect_fewer_branches(surface, smooth_direction_field(surface),
                                                        stripes, {0.25f}, 2.0 / 3);
      all.plain += spare.plain;
      all.yielded += spare.yielded;
    }
  }
  EXPECT_LE(2 * all.yielded, all.plain);
}

TEST(SlackTest, ATenthLeavesNoMoreBranchesThanTheGlobalSolver) {
  if (!is_available(Solver::global)) GTEST_SKIP() << "this build has no CHOLMOD";
  const Surface surface = make_surface(make_shape("trefoil"));
  SmoothFieldOptions smooth;
  smooth.curvature_anchor = 0.1f;
  const DirectionField field =
      rotated(smooth_direction_field(surface, smooth), surface.normals, 0.6108652f);
  const float frequency = frequency_of_stripes(40, bounding_box(surface.mesh).diagonal());
  StripeOptions global;
  global.solver.solver = Solver::global;
  EXPECT_LE(stripe_pattern(surface, field, frequency, with_slack(0.1f)).quality.branches,
            stripe_pattern(surface, field, frequency, global).quality.branches);
}

TEST(SlackTest, KeepsWhatWasAskedFor) {
  const auto s = wavy_surface("torus,resolution=60", kAxis, 20);
  const Surface surface = surface_with(s);
  const StripePattern plain = stripe_pattern(surface, s.waves);
  EXPECT_TRUE(plain.frequencies_wanted.empty());
  EXPECT_FALSE(plain.frequency_change);
  EXPECT_EQ(plain.quality.spacing_error_wanted_mean, plain.quality.spacing_error_mean);
  const StripePattern yielded = stripe_pattern(surface, s.waves, with_slack(0.2f));
  EXPECT_EQ(yielded.frequencies_wanted, s.waves.frequencies);
  EXPECT_NE(yielded.waves.frequencies, s.waves.frequencies);
  ASSERT_TRUE(yielded.frequency_change);
  EXPECT_GT(yielded.quality.spacing_error_wanted_mean, yielded.quality.spacing_error_mean);
}

TEST(SlackTest, TexturesYieldBothWays) {
  const auto s = wavy_surface("torus,resolution=60", kAxis, 20);
  TextureOptions options;
  options.stripes.slack = 0.2f;
  const TexturePattern texture = texture_pattern(surface_with(s), s.waves, options);
  EXPECT_NE(texture.u.waves.frequencies, texture.v.waves.frequencies);
  EXPECT_EQ(texture.v.frequencies_wanted, s.waves.frequencies);
}

TEST(SlackTest, CrossesYieldOnTheirCover) {
  const Surface surface = make_surface(make_shape("box"));
  SmoothFieldOptions four;
  four.symmetry = 4;
  // Wider tiles have hardly a branch but those of the corners.
  const WaveSet waves{
      surface.mesh.positions, smooth_direction_field(surface, four),
      constant_frequency_field(frequency_of_stripes(60, bounding_box(surface.mesh).diagonal()),
                               surface.mesh.vertex_count())};
  const CrossPattern plain = cross_pattern(surface, waves);
  StripeOptions options = with_slack(0.25f);
  options.slack.branch_penalty.assign(surface.mesh.vertex_count(), 0);
  const CrossPattern yielded = cross_pattern(surface, waves, options);
  EXPECT_LT(yielded.quality.branches, plain.quality.branches);
  EXPECT_LT(yielded.pattern.solution.energy, plain.pattern.solution.energy);
  EXPECT_EQ(yielded.cover.waves.frequencies, yielded.pattern.waves.frequencies);
  EXPECT_EQ(yielded.quality.branches_in_avoided_area, 0u);
  const CrossTexture texture = cross_texture(surface, yielded);
  EXPECT_EQ(texture.pattern.u.frequencies_wanted.size(), texture.surface.mesh.vertex_count());
}

#ifdef BRINDLE_HAS_NANOFLANN
TEST(SlackTest, PointsFollowTheirFieldMoreClosely) {
  const Mesh mesh = make_shape("trefoil,resolution=48");
  const Surface points = make_point_surface(make_point_cloud(mesh.positions).cloud);
  const DirectionField field = projected_direction_field(kAxis, points.normals);
  const float frequency = frequency_of_stripes(40, bounding_box(mesh).diagonal());
  const StripePattern plain = stripe_pattern(points, field, frequency);
  const StripePattern yielded = stripe_pattern(points, field, frequency, with_slack(0.25f));
  EXPECT_LT(yielded.solution.energy, 0.6 * plain.solution.energy);
  EXPECT_LT(yielded.quality.angle_error_mean_deg, plain.quality.angle_error_mean_deg);
}
#endif

/// 1 where x is below the middle.
std::vector<float> calm_half(const Mesh& mesh) {
  const float middle = (bounding_box(mesh).lower.x() + bounding_box(mesh).upper.x()) / 2;
  std::vector<float> branch_penalty;
  for (const Vec3& p : mesh.positions) branch_penalty.push_back(p.x() < middle ? 1.0f : 0.0f);
  return branch_penalty;
}

TEST(SlackTest, PenaltiesPushBranchesElsewhere) {
  const auto s = wavy_surface("trefoil", kAxis, 100);
  Slack slack = 0.05f;
  slack.branch_penalty = calm_half(s.mesh);
  const StripePattern branch_penalty = stripe_pattern(surface_with(s), s.waves, with_slack(slack));
  // The same half counted, with nothing asked of it.
  StripePattern plain = stripe_pattern(surface_with(s), s.waves, with_slack(0.05f));
  std::size_t before = 0;
  for (std::size_t t = 0; t < plain.corners.size(); ++t) {
    const TriangleKind kind = plain.corners[t].kind;
    if (kind != TriangleKind::branch && kind != TriangleKind::field_singularity) continue;
    float sum = 0;
    for (const Index v : s.mesh.triangles[t]) sum += slack.branch_penalty[v];
    before += sum >= 1.5f;
  }
  ASSERT_TRUE(branch_penalty.quality.branches_in_avoided_area);
  EXPECT_LT(static_cast<double>(*branch_penalty.quality.branches_in_avoided_area),
            0.85 * static_cast<double>(before));
}

FrameInput input_for(const WavySurface& s) {
  return {s.waves.positions, s.waves.directions, s.waves.frequencies};
}

AnimatorOptions frames_with_slack(float slack) {
  AnimatorOptions options;
  options.slack = slack;
  return options;
}

TEST(SlackTest, FramesKeepTheirFrequency) {
  auto s = wavy_surface("torus,resolution=60", kAxis, 20);
  StripeAnimator animator(surface_with(s), frames_with_slack(0.2f));
  const FrameResult first = animator.frame(input_for(s));
  const StripePattern pattern = stripe_pattern(surface_with(s), s.waves, with_slack(0.2f));
  EXPECT_TRUE(std::ranges::equal(first.frequencies, pattern.waves.frequencies));
  EXPECT_EQ(first.frequency_change.share_at_bounds, pattern.frequency_change->share_at_bounds);
  const std::vector<Complex> z(first.z.begin(), first.z.end());
  const FrameResult again = animator.frame(input_for(s));
  EXPECT_TRUE(again.unchanged);
  EXPECT_TRUE(std::ranges::equal(again.z, z));
  EXPECT_TRUE(std::ranges::equal(again.frequencies, pattern.waves.frequencies));
  s.waves.directions = rotated(s.waves.directions, s.normals, 0.05f);
  const FrameResult turned = animator.frame(input_for(s));
  EXPECT_FALSE(turned.unchanged);
  EXPECT_LE(turned.frequency_change.sweeps, 6);
  EXPECT_FALSE(std::ranges::equal(turned.frequencies, pattern.waves.frequencies));
}

TEST(SlackTest, FramesOfOneSurfaceWithoutSlackAreThoseOfItsNeighbourhood) {
  const auto s = wavy_surface("torus,resolution=60", kAxis, 20);
  StripeAnimator of_surface(surface_with(s)), of_graph(s.neighborhood);
  const FrameResult a = of_surface.frame(input_for(s)), b = of_graph.frame(input_for(s));
  EXPECT_TRUE(std::ranges::equal(a.z, b.z));
  EXPECT_TRUE(a.frequencies.empty());
}

TEST(SlackTest, CancelledFramesLeaveNoTrace) {
  auto s = wavy_surface("torus,resolution=60", kAxis, 20);
  AnimatorOptions options = frames_with_slack(0.2f);
  options.cycles = 2;
  const auto see = [&](int cancelled) {
    StripeAnimator animator(surface_with(s), options);
    auto turned = s;
    std::vector<Complex> seen;
    for (int n = 0; n < 3; ++n) {
      turned.waves.directions = rotated(turned.waves.directions, s.normals, 0.03f);
      if (cancelled >= 0) {
        auto other = turned;
        other.waves.directions = rotated(other.waves.directions, s.normals, 0.4f);
        Reports reports(n == 0 ? cancelled : 1);
        EXPECT_THROW(animator.frame(input_for(other), reports.progress()), Cancelled);
      }
      const FrameResult frame = animator.frame(input_for(turned));
      seen.insert(seen.end(), frame.z.begin(), frame.z.end());
      for (const float f : frame.frequencies) seen.emplace_back(f);
    }
    return seen;
  };
  const std::vector<Complex> undisturbed = see(-1);
  for (const int cancelled : {0, 3, 8}) EXPECT_EQ(see(cancelled), undisturbed) << cancelled;
}

TEST(SlackTest, SiblingsAndRestartsBeginAnew) {
  auto s = wavy_surface("torus,resolution=60", kAxis, 20);
  StripeAnimator animator(surface_with(s), frames_with_slack(0.2f));
  const FrameResult first = animator.frame(input_for(s));
  const FrequencyField frequencies(first.frequencies.begin(), first.frequencies.end());
  StripeAnimator sibling = animator.sibling();
  EXPECT_TRUE(std::ranges::equal(sibling.frame(input_for(s)).frequencies, frequencies));
  auto turned = s;
  turned.waves.directions = rotated(turned.waves.directions, s.normals, 0.3f);
  animator.frame(input_for(turned));
  animator.restart();
  EXPECT_TRUE(std::ranges::equal(animator.frame(input_for(s)).frequencies, frequencies));
}

/// What frequencies asked for were multiplied by.
std::vector<float> ratios(std::span<const float> chosen, const FrequencyField& wanted) {
  std::vector<float> result(chosen.begin(), chosen.end());
  for (std::size_t v = 0; v < result.size(); ++v) result[v] /= wanted[v];
  return result;
}

double mean_difference(const std::vector<float>& a, const std::vector<float>& b) {
  double sum = 0;
  for (std::size_t v = 0; v < a.size(); ++v) sum += static_cast<double>(std::abs(a[v] - b[v]));
  return sum / static_cast<double>(a.size());
}

TEST(SlackTest, MayChangeFromFrameToFrame) {
  const auto s = wavy_surface("trefoil", kAxis, 40);
  StripeAnimator animator(surface_with(s), frames_with_slack(0.3f));
  animator.frame(input_for(s));
  for (const float slack : {0.25f, 0.1f, 0.3f}) {
    SCOPED_TRACE(slack);
    animator.set_slack(slack);
    const FrameResult frame = animator.frame(input_for(s));
    EXPECT_FALSE(frame.unchanged);
    const std::vector<float> chosen = ratios(frame.frequencies, s.waves.frequencies);
    EXPECT_LE(std::ranges::max(chosen), 1 + slack + 1e-5f);
    EXPECT_GE(std::ranges::min(chosen), 1 / (1 + slack) - 1e-5f);
    const StripePattern afresh = stripe_pattern(surface_with(s), s.waves, with_slack(slack));
    EXPECT_LT(mean_difference(chosen, ratios(afresh.waves.frequencies, s.waves.frequencies)), 0.01);
  }
  animator.set_slack(0);
  EXPECT_TRUE(std::ranges::equal(animator.frame(input_for(s)).frequencies, s.waves.frequencies));
}

TEST(SlackTest, PenaltiesMayChangeFromFrameToFrame) {
  const auto s = wavy_surface("torus,resolution=60", kAxis, 20);
  Slack slack = 0.1f;
  slack.branch_penalty = calm_half(s.mesh);
  StripeAnimator animator(surface_with(s), frames_with_slack(0.2f));
  animator.frame(input_for(s));
  animator.set_slack(slack);
  const StripePattern afresh = stripe_pattern(surface_with(s), s.waves, with_slack(slack));
  const FrameResult frame = animator.frame(input_for(s));
  EXPECT_TRUE(std::ranges::equal(frame.frequencies, afresh.waves.frequencies));
  EXPECT_EQ(frame.frequency_change.share_at_bounds, afresh.frequency_change->share_at_bounds);
}

TEST(SlackTest, ThatIsRefusedChangesNothing) {
  const auto s = wavy_surface("torus,resolution=60", kAxis, 20);
  StripeAnimator without(surface_with(s)), animator(surface_with(s), frames_with_slack(0.2f));
  EXPECT_THROW(without.set_slack(0.1f), Error);
  animator.frame(input_for(s));
  Slack short_calm = 0.1f;
  short_calm.branch_penalty = {1};
  for (const Slack& refused : {Slack(-1), short_calm}) {
    EXPECT_THROW(animator.set_slack(refused), Error);
    EXPECT_TRUE(animator.frame(input_for(s)).unchanged);
  }
}

TEST(SlackTest, FramesOfAGraphAloneHaveNone) {
  const auto s = wavy_surface("torus,resolution=20", kAxis, 5);
  EXPECT_THROW(StripeAnimator(s.neighborhood, frames_with_slack(0.2f)), Error);
  EXPECT_THROW(StripeAnimator(surface_with(s), frames_with_slack(-1)), Error);
  EXPECT_THROW(stripe_pattern(surface_with(s), s.waves, with_slack(-1)), Error);
  Slack slack = 0.1f;
  slack.branch_penalty = {1, 2};
  EXPECT_THROW(stripe_pattern(surface_with(s), s.waves, with_slack(slack)), Error);
  EXPECT_THROW(cross_pattern(surface_with(s), s.waves, with_slack(slack)), Error);
}

}  // namespace
}  // namespace brindle
