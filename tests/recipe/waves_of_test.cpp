#include "brindle/waves_of.h"

#include <cmath>
#include <limits>
#include <string_view>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "brindle/direction_field.h"
#include "brindle/error.h"
#include "brindle/pattern_warnings.h"
#include "brindle/shapes.h"
#include "brindle/stripe_pattern.h"
#include "test_meshes.h"

namespace brindle {
namespace {

constexpr float kNone = std::numeric_limits<float>::quiet_NaN();
constexpr float kFrequency = 6;

struct WavesOf : testing::Test {
  const Surface surface = make_surface(make_shape("torus,resolution=24"));
  const WholeSurface whole{surface};
  const std::size_t count = surface.mesh.vertex_count();

  WaveInput found() const {
    return {projected_direction_field({0.2f, 0.3f, 1}, surface.normals),
            FrequencyField(count, kFrequency)};
  }
  /// The same with data that are seen at the scale of their stripes.
  WaveInput measured() const {
    WaveInput waves = found();
    waves.measured.directions = waves.directions;
    return waves;
  }
};

TEST_F(WavesOf, LeavesWhatNobodyWishesToChange) {
  const WaveInput before = found();
  const WaveResult made = waves_of(whole, {}, found());
  EXPECT_EQ(made.waves.positions, surface.mesh.positions);
  EXPECT_EQ(made.waves.directions, before.directions);
  EXPECT_EQ(made.waves.frequencies, before.frequencies);
  EXPECT_TRUE(made.support.coherence.empty() && made.support.filled.empty());
  EXPECT_FALSE(made.smoothing || made.frequency_smoothing || made.missing.without_frequency);
}

TEST_F(WavesOf, TurnsWavesAgainstTheirField) {
  const WaveInput before = found();
  const WaveResult made = waves_of(whole, {.turn_deg = 90}, found());
  for (std::size_t v = 0; v < count; ++v) {
    const Vec3 turned = surface.normals[v].cross(before.directions[v]);
    EXPECT_LT((made.waves.directions[v] - turned).norm(), 1e-6f);
  }
}

struct TurnedPattern {
  WaveResult waves;
  StripePattern pattern;
};

TurnedPattern turned_pattern(Mesh mesh, float turn_deg) {
  const Surface surface = make_surface(std::move(mesh));
  WaveInput found{projected_direction_field({0.31f, 0.9f, 0.27f}, surface.normals),
                  FrequencyField(surface.mesh.vertex_count(), kFrequency)};
  WaveResult waves = waves_of(WholeSurface(surface), {.turn_deg = turn_deg}, std::move(found));
  StripePattern pattern = stripe_pattern(surface, waves.waves);
  return {std::move(waves), std::move(pattern)};
}

TEST(TurnedWaves, DoNotDependOnHowTrianglesAreWound) {
  const Mesh torus = make_shape("torus");
  const TurnedPattern alike = turned_pattern(torus, 20);
  const TurnedPattern mixed = turned_pattern(with_turned_triangles(torus), 20);
  EXPECT_EQ(mixed.waves.turned_apart, 0u);
  EXPECT_EQ(mixed.pattern.quality.branches, alike.pattern.quality.branches);
  EXPECT_NEAR(mixed.pattern.quality.angle_error_mean_deg,
              alike.pattern.quality.angle_error_mean_deg, 1e-4);
  for (std::size_t v = 0; v < alike.waves.waves.directions.size(); ++v) {
    const Vec3 expected = alike.waves.waves.directions[v];
    ASSERT_LT((mixed.waves.waves.directions[v] - expected).norm(), 1e-5f) << v;
  }
}

TEST(TurnedWaves, AreTurnedApartOnASurfaceWithOneSide) {
  const Mesh mobius = make_shape("mobius");
  EXPECT_GT(turned_pattern(mobius, 20).waves.turned_apart, 0u);
  for (const float turn : {0.0f, 90.0f, -180.0f}) {
    EXPECT_EQ(turned_pattern(mobius, turn).waves.turned_apart, 0u) << turn;
  }
  EXPECT_TRUE(turn_warnings(0).empty());
  EXPECT_EQ(turn_warnings(3).size(), 1u);
}

TEST_F(WavesOf, TakesWavesWithoutAFrequencyAndCountsThem) {
  WaveInput gaps = found();
  gaps.frequencies[3] = gaps.frequencies[7] = kNone;
  gaps.directions[7] = Vec3::Zero();  // had no wave anyway
  gaps.may_have_gaps = true;
  const WaveResult made = waves_of(whole, {}, gaps);
  EXPECT_EQ(made.missing.without_frequency, 1U);
  EXPECT_TRUE(made.waves.directions[3].isZero(0));
  for (const float frequency : made.waves.frequencies) EXPECT_EQ(frequency, kFrequency);
}

TEST_F(WavesOf, SeesTheFieldAtItsDetailBeforeItIsTurned) {
  const FieldSmoothingOptions smoothing{.periods = 1, .memory = 1};
  const WaveResult plain = waves_of(whole, {.smoothing = smoothing}, measured());
  const WaveResult turned = waves_of(whole, {.turn_deg = 30, .smoothing = smoothing}, measured());
  ASSERT_TRUE(plain.smoothing.has_value());
  EXPECT_EQ(plain.support.coherence.size(), count);
  EXPECT_EQ(plain.seen_field, plain.waves.directions);
  EXPECT_EQ(turned.seen_field, plain.seen_field);
  EXPECT_EQ(turned.waves.directions,
            rotated(plain.waves.directions, surface.normals, 30 * std::acos(-1.0f) / 180));
  EXPECT_NE(plain.waves.directions, found().directions);
}

TEST_F(WavesOf, HasNoWaveWhereTheFieldIsTooFar) {
  WaveInput near = measured();
  near.is_near = [](Index v) { return v >= 5; };
  const WaveResult made = waves_of(whole, {.smoothing = {.periods = 1}}, near);
  for (Index v = 0; v < count; ++v) {
    EXPECT_EQ(made.waves.directions[v].isZero(0), v < 5) << v;
  }
}

TEST_F(WavesOf, FillsFrequenciesAtTheirDetailBeforeGapsAreTaken) {
  WaveInput gaps = found();
  gaps.frequencies_v = FrequencyField(count, kFrequency / 2);
  gaps.frequencies[3] = gaps.frequencies_v[4] = kNone;
  gaps.may_have_gaps = true;
  const WaveResult made = waves_of(whole, {.frequency_smoothing = {.periods = 1}}, gaps);
  ASSERT_TRUE(made.frequency_smoothing.has_value());
  EXPECT_EQ(made.frequency_smoothing->filled, 1U);
  EXPECT_EQ(made.missing.without_frequency, 0U);
  EXPECT_NEAR(made.waves.frequencies[3], kFrequency, 1e-3f);
  EXPECT_NEAR(made.frequencies_v[4], kFrequency / 2, 1e-3f);
}

TEST_F(WavesOf, SaysWhatIsMissingOnceForEachReason) {
  WaveInput gaps = measured();
  gaps.frequencies[3] = kNone;
  gaps.may_have_gaps = true;
  const WaveResult made = waves_of(whole, {.smoothing = {.periods = 1}}, gaps);
  EXPECT_EQ(made.missing.without_frequency, 1U);
  EXPECT_EQ(made.missing.unfilled, 0U);
  EXPECT_EQ(made.missing.total(), 1U);
}

TEST_F(WavesOf, CanBeCancelled) {
  const Progress stop([](std::string_view, double) { return false; });
  EXPECT_THROW(waves_of(whole, {.smoothing = {.periods = 1}}, measured(), stop), Cancelled);
}

}  // namespace
}  // namespace brindle
