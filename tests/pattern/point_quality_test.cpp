#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "brindle/pattern/quality_sums.h"
#include "phase_graphs.h"

namespace brindle {
namespace {

using testing_support::wavy_surface;
using testing_support::WavySurface;

const Vec3 kAxis(1, 2, 0);

/// Phases of a plane wave that runs along `axis` with `factor` times the frequency.
std::vector<Complex> plane_wave(const WavySurface& s, const Vec3& axis, float factor) {
  std::vector<Complex> z;
  for (std::size_t i = 0; i < s.mesh.vertex_count(); ++i) {
    const float turns =
        factor * s.waves.frequencies[i] * axis.normalized().dot(s.mesh.positions[i]);
    z.push_back(std::polar(1.0f, 2 * std::numbers::pi_v<float> * turns));
  }
  return z;
}

PatternQuality quality(const WavySurface& s, std::span<const Complex> z) {
  return measure_point_quality(*s.neighborhood, s.normals, s.waves, z, PhaseShiftKind::aligned);
}

TEST(PointQuality, OfThePlaneWaveItselfIsPerfect) {
  const WavySurface s = wavy_surface("plane,resolution=40", kAxis, 30);
  const PatternQuality q = quality(s, plane_wave(s, kAxis, 1));
  EXPECT_LT(q.angle_error_mean_deg, 0.01);
  EXPECT_LT(q.spacing_error_mean, 1e-4);
  EXPECT_EQ(q.branches, 0u);
}

TEST(PointQuality, MeasuresAnglesAndSpacings) {
  const WavySurface s = wavy_surface("plane,resolution=40", kAxis, 10);
  const float angle = 10 * std::numbers::pi_v<float> / 180;
  const Vec3 turned(std::cos(angle) * kAxis.x() - std::sin(angle) * kAxis.y(),
                    std::sin(angle) * kAxis.x() + std::cos(angle) * kAxis.y(), 0);
  const PatternQuality q = quality(s, plane_wave(s, turned, 1.2f));
  EXPECT_NEAR(q.angle_error_mean_deg, 10, 0.1);
  EXPECT_NEAR(q.angle_error_share_over_5deg, 1, 1e-9);
  EXPECT_NEAR(q.spacing_error_mean, 0.2, 0.01);
}

TEST(PointQuality, DoesNotDependOnSigns) {
  WavySurface s = wavy_surface("torus,resolution=40", kAxis, 10);
  std::vector<Complex> z = plane_wave(s, kAxis, 1);
  const PatternQuality before = quality(s, z);
  const auto flipped = testing_support::flip_half(s.waves, 3);
  for (std::size_t i = 0; i < z.size(); ++i) {
    if (flipped[i]) z[i] = -std::conj(z[i]);
    s.normals[i] = -s.normals[i];
  }
  EXPECT_NEAR(quality(s, z).angle_error_mean_deg, before.angle_error_mean_deg, 1e-3);
  EXPECT_NEAR(quality(s, z).spacing_error_mean, before.spacing_error_mean, 1e-5);
}

TEST(PointQuality, OfPointsWithoutAWaveIsNothing) {
  WavySurface s = wavy_surface("plane,resolution=10", kAxis, 10);
  const std::vector<Complex> z = plane_wave(s, kAxis, 1);
  for (Vec3& direction : s.waves.directions) direction.setZero();
  EXPECT_EQ(quality(s, z).angle_error_mean_deg, 0);
}

}  // namespace
}  // namespace brindle
