#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "brindle/base/elementary.h"
#include "brindle/pattern/sampling.h"
#include "phase_graphs.h"

#ifdef BRINDLE_HAS_NANOFLANN

namespace brindle {
namespace {

using testing_support::wavy_surface;
using testing_support::WavySurface;

/// A plane wave on the points of a plane.
struct PlaneWave {
  WaveSet waves;
  std::vector<Complex> z;

  PlaneWave(const WavySurface& plane, const Vec3& direction, float frequency) : waves(plane.waves) {
    for (std::size_t i = 0; i < waves.positions.size(); ++i) {
      waves.directions[i] = direction;
      waves.frequencies[i] = frequency;
      z.push_back(std::polar(1.0f, kTwoPi * frequency * direction.dot(waves.positions[i])));
    }
  }
  PointWaves points() const { return {waves, z}; }
};

std::vector<Sample> samples_of(const WavySurface& plane, const PlaneWave& u, const PlaneWave& v) {
  return point_samples(*plane.neighborhood, plane.normals, u.points(), v.points());
}

/// How far a sample is from a peak of a plane wave, in periods.
float off_peak(const Sample& sample, const Vec3& direction, float frequency) {
  const float turns = frequency * direction.dot(sample.position) - 0.25f;
  return std::abs(turns - std::round(turns));
}

TEST(PointSampling, FindsEveryCrossingOnAPlaneOnce) {
  const WavySurface plane = wavy_surface("plane,resolution=30", Vec3::UnitX(), 5);
  const Vec3 d_u(0.8f, 0.6f, 0), d_v(-0.6f, 0.8f, 0);
  // Fewer crossings than points, and several to a point.
  for (const float frequency : {3.0f, 40.0f}) {
    const std::vector<Sample> samples =
        samples_of(plane, PlaneWave(plane, d_u, frequency), PlaneWave(plane, d_v, frequency));
    EXPECT_NEAR(static_cast<double>(samples.size()), 4 * frequency * frequency, 20 * frequency + 5);
    std::size_t inside = 0;
    for (const Sample& sample : samples) {
      EXPECT_LT(off_peak(sample, d_u, frequency), 1e-3f);
      EXPECT_LT(off_peak(sample, d_v, frequency), 1e-3f);
      EXPECT_NEAR(sample.spacing_u, 1 / frequency, 1e-5f);
      inside += sample.position.cwiseAbs().maxCoeff() < 0.8f;
    }
    EXPECT_NEAR(static_cast<double>(inside), 1.6 * 1.6 * frequency * frequency,
                2 + 3.2 * frequency);
    EXPECT_EQ(measure_sample_spacing(samples).double_share, 0);
    EXPECT_NEAR(measure_sample_spacing(samples).mean, 1, 0.01);
  }
}

TEST(PointSampling, TakesWavesThatCrossAtAnAngle) {
  const WavySurface plane = wavy_surface("plane,resolution=30", Vec3::UnitX(), 5);
  const Vec3 d_v(0.6f, 0.8f, 0);
  const auto samples =
      samples_of(plane, PlaneWave(plane, Vec3::UnitX(), 4), PlaneWave(plane, d_v, 6));
  EXPECT_GT(samples.size(), 50u);
  for (const Sample& sample : samples) {
    EXPECT_LT(off_peak(sample, Vec3::UnitX(), 4), 1e-3f);
    EXPECT_LT(off_peak(sample, d_v, 6), 1e-3f);
  }
}

TEST(PointSampling, DoesNotDependOnSigns) {
  const WavySurface plane = wavy_surface("plane,resolution=30", Vec3::UnitX(), 5);
  PlaneWave u(plane, Vec3::UnitX(), 4), v(plane, Vec3::UnitY(), 4);
  const auto before = samples_of(plane, u, v);
  const auto flipped = testing_support::flip_half(u.waves, 3);
  for (std::size_t i = 0; i < flipped.size(); ++i) {
    if (flipped[i]) u.z[i] = -std::conj(u.z[i]);
  }
  EXPECT_EQ(samples_of(plane, u, v).size(), before.size());
}

TEST(PointSampling, FindsNothingWithoutWavesOrWhereTheyRunAlike) {
  const WavySurface plane = wavy_surface("plane,resolution=10", Vec3::UnitX(), 5);
  PlaneWave u(plane, Vec3::UnitX(), 4), v(plane, Vec3::UnitY(), 4);
  EXPECT_TRUE(samples_of(plane, u, u).empty());
  for (Vec3& direction : v.waves.directions) direction.setZero();
  EXPECT_TRUE(samples_of(plane, u, v).empty());
}

}  // namespace
}  // namespace brindle

#endif
