#include <algorithm>
#include <cmath>
#include <filesystem>
#include <numeric>
#include <random>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "brindle/base/parallel.h"
#include "brindle/cross_texture.h"
#include "brindle/error.h"
#include "brindle/files.h"
#include "brindle/frequency_field.h"
#include "brindle/points.h"
#include "brindle/shapes.h"
#include "brindle/smooth_field.h"
#include "brindle/stripe_pattern.h"
#include "phase_graphs.h"

#ifdef BRINDLE_HAS_NANOFLANN

namespace brindle {
namespace {

using testing_support::kAxis;

Surface points_of(const Mesh& mesh) {
  return make_point_surface(make_point_cloud(mesh.positions).cloud);
}

WaveSet waves_along(const Surface& surface, const Vec3& axis, float frequency) {
  return {surface.mesh.positions, projected_direction_field(axis, surface.normals),
          constant_frequency_field(frequency, surface.mesh.vertex_count())};
}

StripePattern pattern_of(const Surface& surface, float frequency = 10) {
  return stripe_pattern(surface, waves_along(surface, kAxis, frequency));
}

void expect_like_quality(const PatternQuality& a, const PatternQuality& b) {
  EXPECT_NEAR(a.angle_error_mean_deg, b.angle_error_mean_deg, 0.1 * b.angle_error_mean_deg);
  EXPECT_NEAR(a.spacing_error_mean, b.spacing_error_mean, 0.1 * b.spacing_error_mean);
}

TEST(PointSurface, StripesOfAPlaneAreThoseOfItsMesh) {
  const Mesh mesh = make_shape("plane,resolution=40");
  const StripePattern pattern = pattern_of(points_of(mesh));
  EXPECT_LT(pattern.solution.energy, 1e-6);
  EXPECT_LT(pattern.quality.angle_error_mean_deg, 0.1);
  EXPECT_LT(pattern.quality.spacing_error_mean, 1e-3);
  EXPECT_EQ(pattern.quality.branches, 0u);
}

TEST(PointSurface, StripesAreAsGoodAsThoseOfTheMesh) {
  for (const char* shape :
       {"sphere,resolution=30", "torus,resolution=120", "trefoil,resolution=30"}) {
    const Mesh mesh = make_shape(shape);
    const StripePattern of_mesh = pattern_of(make_surface(mesh));
    const StripePattern of_points = pattern_of(points_of(mesh));
    EXPECT_LT(of_points.solution.energy, 1.5 * of_mesh.solution.energy + 5e-4) << shape;
    EXPECT_LT(of_points.quality.angle_error_mean_deg,
              1.2 * of_mesh.quality.angle_error_mean_deg + 0.5)
        << shape;
    EXPECT_LT(of_points.quality.spacing_error_mean, 1.2 * of_mesh.quality.spacing_error_mean + 0.01)
        << shape;

    // Laid over the triangles, the phases of the points are a pattern like any other.
    const Surface surface = make_surface(mesh);
    const WaveSet waves = waves_along(surface, kAxis, 10);
    std::vector<Complex> z = of_points.solution.z;
    for (std::size_t i = 0; i < z.size(); ++i) {
      if (waves.directions[i].dot(of_points.waves.directions[i]) < 0) z[i] = -std::conj(z[i]);
    }
    const PatternQuality laid = measure_quality(
        mesh, waves, corner_phases(mesh.triangles, waves, z, PhaseShiftKind::aligned));
    EXPECT_LT(static_cast<double>(laid.branches),
              10 + 1.5 * static_cast<double>(of_mesh.quality.branches))
        << shape;
  }
}

TEST(PointSurface, NormalsOfTheFileAreKeptAndTheirSignsDoNotMatter) {
  const Mesh mesh = make_shape("torus,resolution=80");
  std::vector<Vec3> normals = make_surface(mesh).normals;
  const Surface given = make_point_surface(make_point_cloud(mesh.positions, normals).cloud);
  for (std::size_t i = 0; i < normals.size(); ++i) {
    EXPECT_LT((given.normals[i] - normals[i]).norm(), 1e-6);
  }
  std::mt19937 random(2);
  for (Vec3& normal : normals) {
    if (random() % 2) normal = -normal;
  }
  const Surface flipped = make_point_surface(make_point_cloud(mesh.positions, normals).cloud);
  EXPECT_EQ(pattern_of(flipped).solution.energy, pattern_of(given).solution.energy);

  // Directions of a smooth field turn the other way round where normals do.
  const auto smooth = [](const Surface& surface) {
    WaveSet waves = waves_along(surface, kAxis, 10);
    waves.directions = smooth_direction_field(surface);
    return stripe_pattern(surface, waves).solution.energy;
  };
  EXPECT_NEAR(smooth(flipped), smooth(given), 0.2 * smooth(given));
}

TEST(PointSurface, PatternDoesNotChangeWhenPointsAreMovedAndTurned) {
  Mesh mesh = make_shape("torus,resolution=100");
  const PatternQuality before = pattern_of(points_of(mesh)).quality;
  const Eigen::Matrix3f turn =
      Eigen::AngleAxisf(1.1f, Vec3(1, 2, 3).normalized()).toRotationMatrix();
  for (Vec3& p : mesh.positions) p = turn * p + Vec3(2, -5, 1);
  const Surface moved = points_of(mesh);
  expect_like_quality(stripe_pattern(moved, waves_along(moved, turn * kAxis, 10)).quality, before);
}

TEST(PointSurface, PatternHardlyDependsOnTheOrderOfPoints) {
  Mesh mesh = make_shape("torus,resolution=100");
  const PatternQuality before = pattern_of(points_of(mesh)).quality;
  std::shuffle(mesh.positions.begin(), mesh.positions.end(), std::mt19937(1));
  expect_like_quality(pattern_of(points_of(mesh)).quality, before);
}

TEST(PointSurface, SmoothCurvatureAndCrossFieldsWorkToo) {
  const Surface torus = points_of(make_shape("torus,resolution=120"));
  WaveSet waves = waves_along(torus, kAxis, 10);
  for (const SmoothFieldOptions& options :
       {SmoothFieldOptions{}, SmoothFieldOptions{.curvature_anchor = 0.1f}}) {
    waves.directions = smooth_direction_field(torus, options);
    EXPECT_LT(stripe_pattern(torus, waves).solution.energy, 0.04);
  }
  waves.directions = curvature_direction_field(
      principal_curvatures(torus.mesh.positions, torus.normals, *torus.neighborhood),
      CurvatureDirection::maximum);
  EXPECT_LT(stripe_pattern(torus, waves).solution.energy, 0.04);
  waves.directions = smooth_direction_field(torus, {.symmetry = 4});
  const CrossPattern cross = cross_pattern(torus, waves);
  EXPECT_LT(cross.pattern.solution.energy, 0.04);
  EXPECT_LT(cross.quality.angle_error_mean_deg, 10);
}

TEST(PointSurface, EverySolverSolvesIt) {
  const Surface torus = points_of(make_shape("torus,resolution=60"));
  for (const Solver solver :
       {Solver::relaxation, Solver::averaged, Solver::multilevel, Solver::global}) {
    if (!is_available(solver)) continue;
    StripeOptions options;
    options.solver.solver = solver;
    EXPECT_LT(stripe_pattern(torus, waves_along(torus, kAxis, 6), options).solution.energy, 0.1)
        << name_of(solver);
  }
}

TEST(PointSurface, WhatIsSetAsideCarriesNoWave) {
  Mesh mesh = make_shape("plane,resolution=20");
  mesh.positions.push_back(mesh.positions[7]);
  mesh.positions.emplace_back(std::nanf(""), 0.0f, 0.0f);
  const Surface surface = points_of(mesh);
  const StripePattern pattern = pattern_of(surface);
  for (std::size_t i = mesh.positions.size() - 2; i < mesh.positions.size(); ++i) {
    EXPECT_TRUE(surface.neighborhood->of(static_cast<Index>(i)).empty());
    EXPECT_TRUE(pattern.waves.directions[i].isZero(0));
    EXPECT_TRUE(pattern.solution.z[i] == pattern.solution.z[i]);
  }
  EXPECT_LT(pattern.solution.energy, 1e-6);
  EXPECT_EQ(pattern.quality.vertices_without_wave, 2u);
}

TEST(PointSurface, RefusesCloudsThatAreNone) {
  const PointCloud cloud = make_point_cloud(make_shape("plane,resolution=10").positions).cloud;
  PointCloud bad = cloud;
  bad.positions[3].x() = std::nanf("");
  EXPECT_THROW(make_point_surface(bad), Error);
  bad = cloud;
  bad.used.back() = static_cast<Index>(cloud.positions.size());
  EXPECT_THROW(make_point_surface(bad), Error);
  bad = cloud;
  std::swap(bad.used[2], bad.used[3]);
  EXPECT_THROW(make_point_surface(bad), Error);
  bad = cloud;
  bad.normals.assign(3, Vec3(0, 0, 1));
  EXPECT_THROW(make_point_surface(bad), Error);
  bad.normals.assign(cloud.positions.size(), Vec3(0, 0, std::nanf("")));
  EXPECT_THROW(make_point_surface(bad), Error);
}

TEST(PointSurface, PointsThatFillAVolumeAreRefusedUnlessTheyHaveNormals) {
  std::mt19937 random(1);
  std::uniform_real_distribution<float> coordinate(0, 1);
  std::vector<Vec3> scattered, lattice, rough;
  for (int i = 0; i < 1000; ++i) {
    scattered.push_back({coordinate(random), coordinate(random), coordinate(random)});
    const auto place = static_cast<float>(i);
    lattice.push_back(
        {std::fmod(place, 10.f), std::fmod(std::floor(place / 10), 10.f), std::floor(place / 100)});
    // A surface with noise of half the distance of its points.
    rough.push_back({coordinate(random), coordinate(random), 0.016f * coordinate(random)});
  }
  EXPECT_THROW(make_point_surface(make_point_cloud(scattered).cloud), Error);
  EXPECT_THROW(make_point_surface(make_point_cloud(lattice).cloud), Error);
  EXPECT_NO_THROW(make_point_surface(make_point_cloud(rough).cloud));
  const std::vector<Vec3> normals(scattered.size(), Vec3(0, 0, 1));
  EXPECT_NO_THROW(make_point_surface(make_point_cloud(scattered, normals).cloud));
}

TEST(PointSurface, ThreePointsMakeOneAndFewerOrALineDoNot) {
  const auto surface_of = [](std::vector<Vec3> points) {
    return make_point_surface(make_point_cloud(std::move(points)).cloud);
  };
  EXPECT_LT(pattern_of(surface_of({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}), 0.1f).solution.energy, 0.1);
  EXPECT_THROW(surface_of({}), Error);
  EXPECT_THROW(surface_of({{1, 2, 3}}), Error);
  EXPECT_THROW(surface_of({{1, 2, 3}, {4, 5, 6}}), Error);
  EXPECT_THROW(surface_of({{0, 0, 0}, {1, 1, 1}, {2, 2, 2}, {5, 5, 5}}), Error);
}

TEST(PointSurface, IsTheSameForOneAndTwoThreads) {
  const Mesh mesh = make_shape("torus,resolution=100");
  const ThreadLimit two(2);
  const Surface together = points_of(mesh);
  const StripePattern pattern = pattern_of(together);
  const ThreadLimit one(1);
  const Surface alone = points_of(mesh);
  EXPECT_EQ(together.normals, alone.normals);
  EXPECT_EQ(pattern.solution.z, pattern_of(alone).solution.z);
}

TEST(PointSurface, StripesOfTheHorsesPointsMeetBounds) {
  const auto path = std::filesystem::path(BRINDLE_SHARED_MODELS) / "horse.ply";
  if (!std::filesystem::exists(path)) GTEST_SKIP() << path << " is absent";
  const Surface mesh = make_surface(read_mesh(path).mesh);
  const float frequency = frequency_of_stripes(40, bounding_box(mesh.mesh).diagonal());
  const Surface points = points_of(mesh.mesh);
  // The triangles of this file are wound inwards.
  double agreement = 0, volume = 0;
  for (std::size_t i = 0; i < points.normals.size(); ++i) {
    agreement += points.normals[i].dot(mesh.normals[i]);
    volume += points.normals[i].dot(mesh.mesh.positions[i]);
  }
  EXPECT_LT(agreement / static_cast<double>(points.normals.size()), -0.95);
  EXPECT_GT(volume, 0);
  const StripePattern pattern = pattern_of(points, frequency);
  EXPECT_LT(pattern.solution.energy, 0.006);
  EXPECT_LT(pattern.quality.angle_error_mean_deg, 6);
}

}  // namespace
}  // namespace brindle

#endif
