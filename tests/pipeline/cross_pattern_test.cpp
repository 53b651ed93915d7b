#include <cmath>
#include <filesystem>
#include <random>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "bad_waves.h"
#include "brindle/base/parallel.h"
#include "brindle/cross_texture.h"
#include "brindle/error.h"
#include "brindle/files.h"
#include "brindle/frequency_field.h"
#include "brindle/shapes.h"
#include "brindle/smooth_field.h"

namespace brindle {
namespace {

WaveSet crosses_on(const Surface& surface, DirectionField directions, float stripes) {
  const float diagonal = bounding_box(surface.mesh).diagonal();
  return {surface.mesh.positions, std::move(directions),
          constant_frequency_field(frequency_of_stripes(stripes, diagonal),
                                   surface.mesh.vertex_count())};
}

WaveSet smooth_crosses(const Surface& surface, float stripes) {
  return crosses_on(surface, smooth_direction_field(surface, {.symmetry = 4}), stripes);
}

/// Turns about three of four crosses by one to three quarters.
WaveSet with_quarter_turns(WaveSet waves, std::span<const Vec3> normals, unsigned seed = 9) {
  std::mt19937 random(seed);
  for (std::size_t i = 0; i < normals.size(); ++i) {
    for (unsigned turns = random() % 4; turns > 0; --turns) {
      waves.directions[i] = normals[i].cross(waves.directions[i]);
    }
  }
  return waves;
}

/// Ties between equally strong couplings fall in another way, and from there on solutions differ,
/// though not in kind.
void expect_like_crosses(const PatternQuality& a, const PatternQuality& b) {
  EXPECT_EQ(a.field_singularities, b.field_singularities);
  EXPECT_NEAR(static_cast<double>(a.branches), static_cast<double>(b.branches),
              1 + 0.1 * static_cast<double>(b.branches));
  EXPECT_NEAR(a.angle_error_mean_deg, b.angle_error_mean_deg, 0.1 * b.angle_error_mean_deg);
  EXPECT_NEAR(a.spacing_error_mean, b.spacing_error_mean, 0.1 * b.spacing_error_mean);
}

TEST(CrossPattern, OfAFlatPlaneHasNoEnergyAndNoBranchHoweverCrossesAreNamed) {
  const Surface plane = make_surface(make_shape("plane,resolution=40"));
  const WaveSet waves = with_quarter_turns(
      crosses_on(plane, projected_direction_field(Vec3(1, 2, 0), plane.normals), 30),
      plane.normals);
  const CrossPattern cross = cross_pattern(plane, waves);
  EXPECT_LT(cross.pattern.solution.energy, 1e-6);
  EXPECT_EQ(cross.quality.branches, 0u);
  EXPECT_EQ(cross.quality.field_singularities, 0u);
  EXPECT_LT(cross.quality.angle_error_mean_deg, 0.1);
  EXPECT_LT(cross.quality.spacing_error_mean, 1e-3);
}

bool is_the_same(const PatternQuality& a, const PatternQuality& b) {
  return a.branches == b.branches && a.field_singularities == b.field_singularities &&
         std::abs(a.angle_error_mean_deg - b.angle_error_mean_deg) < 1e-3 &&
         std::abs(a.spacing_error_mean - b.spacing_error_mean) < 1e-4;
}

// Where two names of a cross are equally near to a neighbour's, its number decides, so that a few
// branches may lie elsewhere.
TEST(CrossPattern, HardlyChangesWhenCrossesAreTurnedByQuarters) {
  const Surface torus = make_surface(make_shape("torus,resolution=100"));
  const WaveSet waves = smooth_crosses(torus, 30);
  const PatternQuality before = cross_pattern(torus, waves).quality;
  for (const unsigned seed : {9u, 1u, 2u, 3u, 4u}) {
    expect_like_crosses(
        cross_pattern(torus, with_quarter_turns(waves, torus.normals, seed)).quality, before);
  }
}

TEST(CrossPattern, DoesNotChangeWhenDirectionsAreTurnedRound) {
  const Surface torus = make_surface(make_shape("torus,resolution=100"));
  const WaveSet waves = smooth_crosses(torus, 30);
  WaveSet round = waves;
  for (std::size_t i = 0; i < round.directions.size(); i += 3) round.directions[i] *= -1;
  EXPECT_TRUE(
      is_the_same(cross_pattern(torus, round).quality, cross_pattern(torus, waves).quality));
}

TEST(CrossPattern, DoesNotChangeByABitWhenTheSurfaceIsFourTimesAsLarge) {
  const Surface before = make_surface(make_shape("torus,resolution=60"));
  const WaveSet waves = smooth_crosses(before, 20);
  Mesh mesh = before.mesh;
  for (Vec3& p : mesh.positions) p *= 4;
  const Surface after = make_surface(std::move(mesh));
  WaveSet large = waves;
  large.positions = after.mesh.positions;
  for (float& f : large.frequencies) f /= 4;
  const CrossPattern a = cross_pattern(before, waves), b = cross_pattern(after, large);
  EXPECT_EQ(a.pattern.solution.z, b.pattern.solution.z);
  EXPECT_EQ(a.quality.angle_error_mean_deg, b.quality.angle_error_mean_deg);
  EXPECT_EQ(a.quality.spacing_error_mean, b.quality.spacing_error_mean);
}

TEST(CrossPattern, DoesNotChangeWhenTheSurfaceIsMovedTurnedAndScaled) {
  const Surface before = make_surface(make_shape("torus,resolution=100"));
  const WaveSet waves = smooth_crosses(before, 30);
  const Eigen::Matrix3f turn =
      Eigen::AngleAxisf(1.1f, Vec3(1, 2, 3).normalized()).toRotationMatrix();
  Mesh mesh = before.mesh;
  for (Vec3& p : mesh.positions) p = 3 * (turn * p) + Vec3(2, -5, 1);
  const Surface after = make_surface(std::move(mesh));
  WaveSet moved = waves;
  moved.positions = after.mesh.positions;
  for (Vec3& d : moved.directions) d = turn * d;
  for (float& f : moved.frequencies) f /= 3;
  expect_like_crosses(cross_pattern(after, moved).quality, cross_pattern(before, waves).quality);
}

TEST(CrossPattern, OnASphereHasAtLeastEightSingularities) {
  // Each counts a quarter; they sum to the Euler characteristic, 2.
  const Surface sphere = make_surface(make_shape("sphere,resolution=20"));
  const CrossPattern cross = cross_pattern(sphere, smooth_crosses(sphere, 30));
  EXPECT_GE(cross.quality.field_singularities, 8u);
  EXPECT_LE(cross.quality.field_singularities, 16u);
  EXPECT_GE(cross.quality.branches, 2 * cross.quality.field_singularities);
}

TEST(CrossPattern, BranchesIncludeBothWavesAtEverySingularity) {
  const Surface plane = make_surface(make_shape("plane,resolution=21"));
  DirectionField field;
  for (const Vec3& p : plane.mesh.positions) {
    const float angle = std::atan2(p.y() - 0.021f, p.x() - 0.013f) / 4;
    field.emplace_back(std::cos(angle), std::sin(angle), 0.0f);
  }
  const CrossPattern cross = cross_pattern(plane, crosses_on(plane, std::move(field), 6));
  EXPECT_EQ(cross.quality.field_singularities, 1u);
  EXPECT_EQ(cross.quality.branches, cross.pattern.quality.branches + 2);
}

TEST(CrossPattern, BothWavesAreOrthogonalAwayFromBranches) {
  const Surface torus = make_surface(make_shape("torus,resolution=120"));
  const CrossPattern cross = cross_pattern(torus, smooth_crosses(torus, 30));
  EXPECT_LT(cross.quality.angle_error_mean_deg, 6);
  EXPECT_LT(cross.quality.spacing_error_mean, 0.1);
}

TEST(CrossPattern, IsSolvedByEverySolver) {
  const Surface torus = make_surface(make_shape("torus,resolution=60"));
  const WaveSet waves = smooth_crosses(torus, 15);
  for (const Solver solver :
       {Solver::relaxation, Solver::averaged, Solver::multilevel, Solver::global}) {
    if (!is_available(solver)) continue;
    StripeOptions options;
    options.solver.solver = solver;
    options.weights = EdgeWeights::cotangent;
    EXPECT_LT(cross_pattern(torus, waves, options).pattern.solution.energy, 0.1) << name_of(solver);
  }
}

TEST(CrossPattern, IsTheSameForOneAndTwoThreads) {
  const Surface torus = make_surface(make_shape("torus,resolution=100"));
  const WaveSet waves = smooth_crosses(torus, 30);
  const ThreadLimit two(2);
  const CrossPattern together = cross_pattern(torus, waves);
  const ThreadLimit one(1);
  const CrossPattern alone = cross_pattern(torus, waves);
  EXPECT_EQ(together.pattern.solution.z, alone.pattern.solution.z);
  EXPECT_EQ(together.quality.angle_error_mean_deg, alone.quality.angle_error_mean_deg);
}

TEST(CrossPattern, IsLaidOverSurfacesOfAnyTopology) {
  for (const char* shape : {"sheets,resolution=24", "hemisphere,resolution=30",
                            "mobius,resolution=20", "pieces,resolution=10", "box,resolution=20"}) {
    const Surface surface = make_surface(make_shape(shape));
    const CrossPattern cross = cross_pattern(surface, smooth_crosses(surface, 20));
    EXPECT_LT(cross.pattern.solution.energy, 0.1) << shape;
    EXPECT_LT(cross.quality.branches, surface.mesh.triangle_count() / 20) << shape;
  }
}

TEST(CrossPattern, RefusesValuesThatNoCrossHas) {
  const Surface torus = make_surface(make_shape("torus,resolution=20"));
  const WaveSet waves =
      crosses_on(torus, projected_direction_field(Vec3(1, 2, 0), torus.normals), 9);
  testing_support::expect_refused(waves, 5, [&](const WaveSet& bad) { cross_pattern(torus, bad); });
  WaveSet upright = waves;
  upright.directions[4] = torus.normals[4];
  EXPECT_THROW(cross_pattern(torus, upright), Error);
}

TEST(CrossPattern, CountsVerticesWithoutACrossOnce) {
  const Surface torus = make_surface(make_shape("torus,resolution=20"));
  WaveSet waves = crosses_on(torus, projected_direction_field(Vec3(1, 2, 0), torus.normals), 9);
  EXPECT_EQ(cross_pattern(torus, waves).quality.vertices_without_wave, 0u);
  for (const int vertex : {3, 50, 51}) waves.directions[vertex].setZero();
  EXPECT_EQ(cross_pattern(torus, waves).quality.vertices_without_wave, 3u);
}

TEST(CrossPattern, RefusesWavesOfAnotherSurface) {
  const Surface plane = make_surface(make_shape("plane,resolution=5"));
  WaveSet waves = smooth_crosses(plane, 5);
  waves.directions.pop_back();
  EXPECT_THROW(cross_pattern(plane, waves), Error);
}

TEST(CrossPattern, OnTheHorseIsAboutAsRegularAsTheOrthogonalPair) {
  const auto path = std::filesystem::path(BRINDLE_SHARED_MODELS) / "horse.ply";
  if (!std::filesystem::exists(path)) GTEST_SKIP() << path << " is absent";
  const Surface horse = make_surface(read_mesh(path).mesh);
  const CrossPattern cross = cross_pattern(horse, smooth_crosses(horse, 40));
  WaveSet pair = crosses_on(horse, smooth_direction_field(horse), 40);
  const PatternQuality u = stripe_pattern(horse, pair).quality;
  pair.directions = rotated(pair.directions, horse.normals, std::acos(0.0f));
  const PatternQuality v = stripe_pattern(horse, pair).quality;
  // A cross may turn by a quarter, so it turns more gently between more singularities.
  EXPECT_GT(cross.quality.field_singularities, u.field_singularities);
  EXPECT_LT(cross.quality.angle_error_mean_deg,
            1.1 * (u.angle_error_mean_deg + v.angle_error_mean_deg) / 2);
  EXPECT_LT(static_cast<double>(cross.quality.branches),
            1.5 * static_cast<double>(u.branches + v.branches));
}

}  // namespace
}  // namespace brindle
