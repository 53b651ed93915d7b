#include <cmath>

#include <gtest/gtest.h>

#include "brindle/base/elementary.h"
#include "brindle/texture_waves.h"
#include "phase_graphs.h"

namespace brindle {
namespace {

/// Plane waves along two directions; phases have `stretch` times the frequency that they are meant
/// to have.
TextureWaves plane_texture(const Mesh& mesh, const Vec3& u, const Vec3& v, float stretch) {
  constexpr float kFrequency = 3;
  const auto set = [&](const Vec3& direction) {
    return WaveSet{mesh.positions, std::vector<Vec3>(mesh.vertex_count(), direction),
                   std::vector<float>(mesh.vertex_count(), kFrequency)};
  };
  const auto phases = [&](const Vec3& direction) {
    std::vector<Complex> z;
    for (const Vec3& p : mesh.positions) {
      z.push_back(std::polar(1.0f, kTwoPi * stretch * kFrequency * direction.dot(p)));
    }
    return z;
  };
  return texture_waves(mesh.triangles, set(u), phases(u), set(v), phases(v));
}

TextureQuality quality_of(const Vec3& u, const Vec3& v, float stretch) {
  const Mesh mesh = make_shape("plane,resolution=20");
  return measure_texture(mesh, plane_texture(mesh, u, v, stretch), PhaseShiftKind::aligned);
}

TEST(TextureQuality, OrthogonalWavesHaveNone) {
  const TextureQuality quality = quality_of({0.6f, 0.8f, 0}, {-0.8f, 0.6f, 0}, 1);
  EXPECT_NEAR(quality.angle_mean_deg, 0, 0.05);
  EXPECT_NEAR(quality.area_95th, 0, 2e-3);
}

TEST(TextureQuality, AngleIsWhatWavesLackToARightAngle) {
  const float sine = std::sqrt(0.75f);
  const TextureQuality quality = quality_of({1, 0, 0}, {0.5f, sine, 0}, 1);
  EXPECT_NEAR(quality.angle_mean_deg, 30, 0.05);
  EXPECT_NEAR(quality.angle_95th_deg, 30, 0.05);
  EXPECT_NEAR(quality.area_mean, 1 / sine - 1, 2e-3);  // as large in a leaning tile
}

TEST(TextureQuality, AreaIsTheSameForTilesTooSmallAndTooLarge) {
  EXPECT_NEAR(quality_of({1, 0, 0}, {0, 1, 0}, 1.2f).area_mean, 0.44, 5e-3);
  EXPECT_NEAR(quality_of({1, 0, 0}, {0, 1, 0}, 1 / 1.2f).area_mean, 0.44, 5e-3);
}

TEST(TextureQuality, OfATextureWithoutWavesMeasuresNothing) {
  const Mesh mesh = make_shape("plane,resolution=8");
  const TextureQuality quality = measure_texture(
      mesh, plane_texture(mesh, Vec3::Zero(), Vec3::UnitY(), 1), PhaseShiftKind::aligned);
  EXPECT_EQ(quality.measured_triangles, 0u);
  EXPECT_EQ(quality.angle_95th_deg, 0);
}

}  // namespace
}  // namespace brindle
