#include "brindle/stripe_tracer.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "brindle/direction_field.h"
#include "brindle/error.h"
#include "brindle/points.h"
#include "brindle/shapes.h"

namespace brindle {
namespace {

struct StripeTracerTest : testing::Test {
  Surface surface = make_surface(make_shape("trefoil,resolution=60"));
  DirectionField field = projected_direction_field({0.3f, 0.9f, 0.3f}, surface.normals);
  StripePattern u = stripe_pattern(surface, field, 6);
  StripePattern v =
      stripe_pattern(surface, rotated(field, surface.normals, std::numbers::pi_v<float> / 2), 6);
  StripeTracer tracer{surface};
};

void expect_same(const StripeCurves& a, const StripeCurves& b) {
  EXPECT_EQ(a.lines.points, b.lines.points);
  EXPECT_EQ(a.lines.offsets, b.lines.offsets);
  EXPECT_EQ(a.ends, b.ends);
}

TEST_F(StripeTracerTest, GivesWhatFunctionsGiveThatAskOnce) {
  const StripeCurves curves = tracer.curves(u);
  EXPECT_GT(curves.lines.count(), 10);
  expect_same(curves, stripe_curves(surface, u));
  expect_same(tracer.curves(v, {.join = true}), stripe_curves(surface, v, {.join = true}));
  if (!has_point_trees()) return;
  std::vector<Sample> samples = tracer.crossings(u, v);
  const std::size_t all = samples.size();
  EXPECT_GT(drop_doubles(samples), 0);
  EXPECT_LT(samples.size(), all);
  const std::vector<Sample> wanted = stripe_samples(surface, u, v);
  ASSERT_EQ(samples.size(), wanted.size());
  for (std::size_t i = 0; i < samples.size(); ++i) {
    EXPECT_EQ(samples[i].position, wanted[i].position);
  }
  const auto spacing = tracer.spacing(u, curves);
  const auto gaps = measure_curves(surface, u, curves).gaps;
  ASSERT_TRUE(spacing && gaps);
  EXPECT_NEAR(spacing->mean, 1, 0.1);
  EXPECT_EQ(spacing->gaps.measured, gaps->measured);
  EXPECT_EQ(spacing->gaps.mean, gaps->mean);
}

TEST_F(StripeTracerTest, WithoutCurvesThereIsNoSpacing) {
  EXPECT_EQ(tracer.spacing(u, StripeCurves{}), std::nullopt);
}

TEST_F(StripeTracerTest, RefusesPatternsOfOtherSurfaces) {
  const Surface other = make_surface(make_shape("torus,resolution=20"));
  const StripePattern of_other =
      stripe_pattern(other, projected_direction_field({0, 1, 0}, other.normals), 6);
  EXPECT_THROW(tracer.curves(of_other), Error);
  EXPECT_THROW(tracer.spacing(of_other, {}), Error);
  EXPECT_THROW(tracer.crossings(u, of_other), Error);
  EXPECT_THROW(tracer.crossings(of_other, v), Error);
  StripePattern moved = of_other;
  EXPECT_THROW(shift_stripes(surface, 0.5f, moved), Error);
  EXPECT_EQ(moved.solution.z, of_other.solution.z);
}

TEST_F(StripeTracerTest, StripesMoveForwardByPeriods) {
  StripePattern whole = u, half = u, twice = u;
  EXPECT_EQ(shift_stripes(surface, 1, whole), 0);
  EXPECT_EQ(shift_stripes(surface, 0.5f, half), 0);
  shift_stripes(surface, 0.25f, twice);
  shift_stripes(surface, 0.25f, twice);
  for (std::size_t i = 0; i < u.solution.z.size(); ++i) {
    EXPECT_LT(std::abs(whole.solution.z[i] - u.solution.z[i]), 1e-5f);
    EXPECT_LT(std::abs(half.solution.z[i] + u.solution.z[i]), 1e-5f);
    // A quarter needs waves that run alike, and turns phases with them: z becomes -conj(z).
    const bool is_turned = twice.waves.directions[i].dot(u.waves.directions[i]) < 0;
    const Complex wanted = is_turned ? -std::conj(half.solution.z[i]) : half.solution.z[i];
    EXPECT_LT(std::abs(twice.solution.z[i] - wanted), 1e-5f);
  }
}

}  // namespace
}  // namespace brindle
