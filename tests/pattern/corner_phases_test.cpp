#include "brindle/corner_phases.h"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "brindle/base/elementary.h"
#include "brindle/quality.h"
#include "brindle/solver.h"
#include "phase_graphs.h"

namespace brindle {
namespace {

using testing_support::flip_half;
using testing_support::wavy_surface;

struct StripedPlane {
  testing_support::WavySurface surface;
  std::vector<Complex> z;
};

/// Far more stripes than triangles: several cross each.
StripedPlane striped_plane(float stripes) {
  StripedPlane wave{wavy_surface("plane,resolution=12", Vec3(1, 0.5f, 0), stripes), {}};
  for (std::size_t i = 0; i < wave.surface.mesh.vertex_count(); ++i) {
    const float along = wave.surface.waves.directions[i].dot(wave.surface.mesh.positions[i]);
    wave.z.push_back(std::polar(1.0f, kTwoPi * wave.surface.waves.frequencies[i] * along));
  }
  return wave;
}

TEST(CornerPhases, LiftAPlaneWaveToItsLinearPhaseAtAnyFrequency) {
  for (const float stripes : {4.0f, 40.0f, 200.0f}) {
    const StripedPlane wave = striped_plane(stripes);
    const auto& [surface, z] = wave;
    const auto corners =
        corner_phases(surface.mesh.triangles, surface.waves, z, PhaseShiftKind::aligned);
    for (std::size_t t = 0; t < corners.size(); ++t) {
      ASSERT_EQ(corners[t].kind, TriangleKind::regular);
      const Triangle& triangle = surface.mesh.triangles[t];
      for (int m = 1; m < 3; ++m) {
        const Vec3 edge = surface.mesh.positions[triangle[m]] - surface.mesh.positions[triangle[0]];
        const float expected =
            kTwoPi * surface.waves.frequencies[0] * surface.waves.directions[triangle[0]].dot(edge);
        ASSERT_NEAR(corners[t].phase[m] - corners[t].phase[0], expected, 1e-3f);
      }
    }
    const PatternQuality quality = measure_quality(surface.mesh, surface.waves, corners);
    EXPECT_EQ(quality.branches, 0u);
    EXPECT_LT(quality.angle_error_mean_deg, 0.05);
    EXPECT_LT(quality.spacing_error_mean, 1e-3);
    EXPECT_EQ(quality.angle_error_share_over_5deg, 0);
  }
}

TEST(CornerPhases, DoNotCareWhichWayDirectionsPoint) {
  StripedPlane wave = striped_plane(20);
  const auto flipped = flip_half(wave.surface.waves, 9);
  for (std::size_t i = 0; i < flipped.size(); ++i) {
    if (flipped[i]) wave.z[i] = -std::conj(wave.z[i]);
  }
  const auto corners = corner_phases(wave.surface.mesh.triangles, wave.surface.waves, wave.z,
                                     PhaseShiftKind::aligned);
  const PatternQuality quality = measure_quality(wave.surface.mesh, wave.surface.waves, corners);
  EXPECT_EQ(quality.branches, 0u);
  EXPECT_LT(quality.angle_error_mean_deg, 0.05);
}

TEST(CornerPhases, AVortexOfPhasesIsOneBranchOfItsSign) {
  WaveSet waves{{Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0)},
                std::vector<Vec3>(3, Vec3(1, 0, 0)),
                std::vector<float>(3, 1e-3f)};
  const std::vector<Complex> z{std::polar(1.0f, 0.0f), std::polar(1.0f, kTwoPi / 3),
                               std::polar(1.0f, -kTwoPi / 3)};
  EXPECT_EQ(corner_phases(corner_waves({0, 1, 2}, waves, z), PhaseShiftKind::aligned).branch_index,
            1);
  EXPECT_EQ(corner_phases(corner_waves({0, 2, 1}, waves, z), PhaseShiftKind::aligned).branch_index,
            -1);
  EXPECT_EQ(corner_phases(corner_waves({0, 1, 2}, waves, z), PhaseShiftKind::aligned).kind,
            TriangleKind::branch);
}

TEST(CornerPhases, KnowSingularitiesOfTheFieldAndMissingWaves) {
  const auto around = [](float degrees) {
    return Vec3(std::cos(degrees * kTwoPi / 360), std::sin(degrees * kTwoPi / 360), 0);
  };
  WaveSet waves{{Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0)},
                {around(0), around(60), around(120)},
                std::vector<float>(3, 1.0f)};
  const std::vector<Complex> z(3, Complex(1));
  EXPECT_EQ(corner_phases(corner_waves({0, 1, 2}, waves, z), PhaseShiftKind::aligned).kind,
            TriangleKind::field_singularity);
  waves.directions[1] = Vec3::Zero();
  EXPECT_EQ(corner_phases(corner_waves({0, 1, 2}, waves, z), PhaseShiftKind::aligned).kind,
            TriangleKind::no_wave);
}

TEST(Quality, BranchesBalanceOnAClosedSurface) {
  // The sum of all branch indices of a torus with an oriented field without singularities is zero.
  auto surface = wavy_surface("torus,resolution=80", Vec3(0, 0, 1), 20);
  for (std::size_t i = 0; i < surface.normals.size(); ++i) {
    const Vec3& p = surface.mesh.positions[i];
    surface.waves.directions[i] = Vec3(-p.y(), p.x(), 0).normalized();
  }
  const PhaseSolution solution = solve_phases(surface.graph());
  int sum = 0, branches = 0;
  for (const CornerPhases& corners :
       corner_phases(surface.mesh.triangles, surface.waves, solution.z, PhaseShiftKind::aligned)) {
    sum += corners.branch_index;
    branches += corners.branch_index != 0;
    ASSERT_NE(corners.kind, TriangleKind::field_singularity);
  }
  EXPECT_EQ(sum, 0);
  EXPECT_GT(branches, 0) << "stripes of equal width around a torus must branch";
}

TEST(Quality, AngleErrorIsThatOfATurnedField) {
  StripedPlane wave = striped_plane(8);
  const float turn = 10 * kTwoPi / 360;
  auto corners = corner_phases(wave.surface.mesh.triangles, wave.surface.waves, wave.z,
                               PhaseShiftKind::aligned);
  wave.surface.waves.directions =
      rotated(wave.surface.waves.directions, wave.surface.normals, turn);
  for (float& f : wave.surface.waves.frequencies) f *= 2;
  const PatternQuality quality = measure_quality(wave.surface.mesh, wave.surface.waves, corners);
  EXPECT_NEAR(quality.angle_error_mean_deg, 10, 0.05);
  EXPECT_EQ(quality.angle_error_share_over_5deg, 1);
  EXPECT_NEAR(quality.spacing_error_mean, 0.5, 1e-3);
  for (const float error : angle_errors_deg(wave.surface.mesh, wave.surface.waves, corners)) {
    EXPECT_NEAR(error, 10, 0.1);
  }
}

}  // namespace
}  // namespace brindle
