#include "brindle/pattern_of.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "brindle/direction_field.h"
#include "brindle/error.h"
#include "brindle/shapes.h"
#include "brindle/smooth_field.h"
#include "brindle/waves_of.h"

namespace brindle {
namespace {

struct PatternOf : testing::Test {
  const Surface surface = make_surface(make_shape("sphere,resolution=14"));
  const std::size_t count = surface.mesh.vertex_count();
  const WaveSet waves{surface.mesh.positions, smooth_direction_field(surface),
                      FrequencyField(count, 5)};

  FrameInput input() const { return {waves.positions, waves.directions, waves.frequencies}; }
};

void expect_same(const StripePattern& a, const StripePattern& b) {
  EXPECT_EQ(a.waves.directions, b.waves.directions);
  EXPECT_EQ(a.waves.frequencies, b.waves.frequencies);
  EXPECT_EQ(a.frequencies_wanted, b.frequencies_wanted);
  EXPECT_EQ(a.solution.z, b.solution.z);
  EXPECT_EQ(a.corners.size(), b.corners.size());
  EXPECT_EQ(a.quality.branches, b.quality.branches);
  EXPECT_EQ(a.quality.angle_error_mean_deg, b.quality.angle_error_mean_deg);
}

TEST_F(PatternOf, IsWhatItsKindMakes) {
  const PatternResult stripes = pattern_of(surface, waves, {});
  expect_same(std::get<StripePattern>(stripes.of), stripe_pattern(surface, waves));
  EXPECT_TRUE(stripes.fabrication.loops.empty());

  const FrequencyField denser(count, 8);
  const PatternResult texture = pattern_of(
      surface, waves, {.kind = PatternKind::texture, .frequencies_v = denser, .oriented = true});
  const TexturePattern expected =
      texture_pattern(surface, waves, {.frequencies_v = denser, .oriented = true});
  expect_same(std::get<TexturePattern>(texture.of).u, expected.u);
  expect_same(std::get<TexturePattern>(texture.of).v, expected.v);
  EXPECT_EQ(std::get<TexturePattern>(texture.of).seams.turned, expected.seams.turned);

  const PatternResult crosses = pattern_of(surface, waves, {.kind = PatternKind::crosses});
  const auto& [cross, drawn] = std::get<CrossResult>(crosses.of);
  expect_same(cross.pattern, cross_pattern(surface, waves).pattern);
  EXPECT_EQ(drawn.surface.mesh.triangle_count(), drawn.pattern.u.corners.size());
}

TEST_F(PatternOf, MeasuresWindingsWhereAsked) {
  const Surface torus = make_surface(make_shape("torus,resolution=40"));
  const WaveSet round{torus.mesh.positions, smooth_direction_field(torus),
                      FrequencyField(torus.mesh.vertex_count(), 5)};
  FabricationOptions fabrication;
  fabrication.measure_windings = true;
  const PatternResult measured = pattern_of(torus, round, {.fabrication = fabrication});
  EXPECT_FALSE(measured.fabrication.loops.empty());
  EXPECT_EQ(measured.fabrication.windings.size(), measured.fabrication.loops.size());
  EXPECT_TRUE(measured.fabrication.windings_before.empty());
  FabricationMetrics again = measured.fabrication;
  measure_windings(torus, std::get<StripePattern>(measured.of), again);
  EXPECT_EQ(again.centers.size(), again.loops.size()) << "metrics of before are gone";
}

TEST_F(PatternOf, MergesBranchesOfEveryKind) {
  FabricationOptions fabrication;
  fabrication.cancel_branches = 0.1f;
  for (const PatternKind kind :
       {PatternKind::stripes, PatternKind::texture, PatternKind::crosses}) {
    EXPECT_FALSE(pattern_of(surface, waves, {.kind = kind}).fabrication.cancelled_branches);
    EXPECT_TRUE(pattern_of(surface, waves, {.kind = kind, .fabrication = fabrication})
                    .fabrication.cancelled_branches);
  }
}

TEST_F(PatternOf, RefusesWhatTheKindDoesNotHave) {
  FabricationOptions fabrication;
  fabrication.measure_windings = true;
  for (const PatternKind kind : {PatternKind::texture, PatternKind::crosses}) {
    EXPECT_THROW(pattern_of(surface, waves, {.kind = kind, .fabrication = fabrication}), Error);
  }
  for (const PatternKind kind : {PatternKind::stripes, PatternKind::crosses}) {
    EXPECT_THROW(pattern_of(surface, waves, {.kind = kind, .oriented = true}), Error);
    EXPECT_THROW(
        pattern_of(surface, waves, {.kind = kind, .frequencies_v = FrequencyField(count, 3)}),
        Error);
  }
}

/// The first frame is solved as a pattern that is made at once.
TEST_F(PatternOf, AFrameIsThePatternMadeAtOnce) {
  StripeAnimator stripes(surface);
  const FrameResult frame = stripes.frame(input());
  const StripePattern of_stripes =
      pattern_of_frame(frame, waves, stripes.energy(), PhaseShiftKind::aligned);
  const StripePattern at_once = stripe_pattern(surface, waves);
  EXPECT_EQ(of_stripes.solution.z, at_once.solution.z);
  EXPECT_EQ(of_stripes.waves.frequencies, waves.frequencies);
  EXPECT_TRUE(of_stripes.frequencies_wanted.empty());
  EXPECT_NEAR(of_stripes.solution.energy, at_once.solution.energy, 1e-9);

  TextureAnimator textures(surface);
  const TextureFrameResult texture = textures.frame({input(), {}, {}});
  const TexturePattern of_texture = pattern_of_frame(texture, textures);
  const TexturePattern laid = texture_pattern(surface, waves);
  expect_same(of_texture.u, laid.u);
  // V's frames share the topology of U, which other couplings have led.
  EXPECT_EQ(of_texture.v.waves.directions, laid.v.waves.directions);
  EXPECT_TRUE(std::ranges::equal(of_texture.v.solution.z, texture.v.z));
  EXPECT_EQ(of_texture.seams.turned, laid.seams.turned);

  CrossAnimator animator(surface);
  const CrossFrameResult crosses = animator.frame({input(), {}});
  const TexturePattern of_cross = pattern_of_frame(crosses, animator, PhaseShiftKind::aligned);
  const CrossTexture drawn = cross_texture(surface, cross_pattern(surface, waves));
  EXPECT_EQ(of_cross.u.waves.positions, drawn.surface.mesh.positions);
  EXPECT_EQ(of_cross.u.waves.directions, drawn.pattern.u.waves.directions);
  ASSERT_EQ(of_cross.u.corners.size(), drawn.pattern.u.corners.size());
  for (std::size_t t = 0; t < of_cross.u.corners.size(); ++t) {
    EXPECT_EQ(of_cross.u.corners[t].kind, drawn.pattern.u.corners[t].kind) << t;
  }
  EXPECT_EQ(of_cross.u.quality.branches, drawn.pattern.u.quality.branches);
}

TEST_F(PatternOf, AFrameWithSlackHasTheFrequenciesChosenAndThoseAskedFor) {
  AnimatorOptions options;
  options.slack = 0.3f;
  StripeAnimator animator(surface, options);
  const FrameResult frame = animator.frame(input());
  const StripePattern pattern =
      pattern_of_frame(frame, waves, animator.energy(), PhaseShiftKind::aligned);
  EXPECT_EQ(pattern.frequencies_wanted, waves.frequencies);
  EXPECT_TRUE(std::ranges::equal(pattern.waves.frequencies, frame.frequencies));
  EXPECT_NE(pattern.waves.frequencies, waves.frequencies);
  EXPECT_TRUE(pattern.frequency_change.has_value());
}

TEST_F(PatternOf, WavesAcrossAreTurnedByAQuarter) {
  const WaveSet across = waves_across(waves, surface.normals);
  for (std::size_t v = 0; v < count; ++v) {
    EXPECT_NEAR(across.directions[v].dot(waves.directions[v]), 0, 1e-6f);
  }
  EXPECT_EQ(across.frequencies, waves.frequencies);
  const FrequencyField own(count, 9);
  EXPECT_EQ(waves_across(waves, surface.normals, own).frequencies, own);
}

}  // namespace
}  // namespace brindle
