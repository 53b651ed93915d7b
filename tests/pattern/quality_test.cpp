#include "brindle/quality.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

namespace brindle {
namespace {

constexpr float kWaveFrequency = 2;

/// Loose triangles in the plane z = 0, crossed by one plane wave along x. Each has a direction of
/// its own, which the errors are measured against.
struct Soup {
  Mesh mesh;
  WaveSet waves;
  std::vector<Complex> z;

  void add(const std::array<Vec3, 3>& corners, float turned_deg) {
    const auto first = static_cast<Index>(mesh.vertex_count());
    const float angle = turned_deg * std::numbers::pi_v<float> / 180;
    for (const Vec3& corner : corners) {
      mesh.positions.push_back(corner);
      waves.positions.push_back(corner);
      waves.directions.emplace_back(std::cos(angle), std::sin(angle), 0);
      waves.frequencies.push_back(kWaveFrequency);
      z.push_back(std::polar(1.0f, 2 * std::numbers::pi_v<float> * kWaveFrequency * corner.x()));
    }
    mesh.triangles.push_back({first, first + 1, first + 2});
  }

  /// The four triangles that halving all edges makes of one.
  void add_in_four(const std::array<Vec3, 3>& corners, float turned_deg) {
    const auto& [a, b, c] = corners;
    const Vec3 ab = (a + b) / 2, bc = (b + c) / 2, ca = (c + a) / 2;
    add({a, ab, ca}, turned_deg);
    add({b, bc, ab}, turned_deg);
    add({c, ca, bc}, turned_deg);
    add({ab, bc, ca}, turned_deg);
  }

  PatternQuality quality() const {
    WaveSet along = waves;
    for (Vec3& direction : along.directions) direction = Vec3::UnitX();
    along.frequencies.assign(along.frequencies.size(), kWaveFrequency);
    const auto corners = corner_phases(mesh.triangles, along, z, PhaseShiftKind::aligned);
    return measure_quality(mesh, waves, corners);
  }
};

const std::array<Vec3, 3> kLarge{Vec3(0, 0, 0), Vec3(2, 0, 0), Vec3(0, 2, 0)};    // area 2
const std::array<Vec3, 3> kSmall{Vec3(0, 0, 0), Vec3(-1, 0, 0), Vec3(0, -1, 0)};  // area 1/2

TEST(Quality, AnglesAreThoseBetweenLines) {
  for (const float turned_deg : {60.0f, 120.0f, 240.0f, 300.0f}) {
    Soup soup;
    soup.add(kLarge, turned_deg);
    EXPECT_NEAR(soup.quality().angle_error_mean_deg, 60, 1e-2) << turned_deg;
  }
}

TEST(Quality, MeansAreWeightedByArea) {
  Soup soup;
  soup.add(kLarge, 2);
  soup.add(kSmall, 12);
  for (int corner = 3; corner < 6; ++corner) soup.waves.frequencies[corner] *= 2;
  const PatternQuality quality = soup.quality();
  EXPECT_NEAR(quality.angle_error_mean_deg, 0.8 * 2 + 0.2 * 12, 1e-2);
  EXPECT_NEAR(quality.angle_error_share_over_5deg, 0.2, 1e-6);
  EXPECT_NEAR(quality.spacing_error_mean, 0.2 * 0.5, 1e-3);
}

TEST(Quality, DoesNotDependOnHowAFlatTriangleIsCut) {
  Soup whole, cut;
  whole.add(kLarge, 2);
  cut.add(kLarge, 2);
  whole.add(kSmall, 12);
  cut.add_in_four(kSmall, 12);
  EXPECT_NEAR(cut.quality().angle_error_mean_deg, whole.quality().angle_error_mean_deg, 1e-2);
  EXPECT_NEAR(cut.quality().angle_error_share_over_5deg,
              whole.quality().angle_error_share_over_5deg, 1e-6);
  EXPECT_NEAR(cut.quality().spacing_error_mean, whole.quality().spacing_error_mean, 1e-3);
}

TEST(Quality, SliversHardlyCount) {
  Soup soup;
  soup.add(kLarge, 2);
  const PatternQuality before = soup.quality();
  for (int n = 0; n < 100; ++n) {
    const float y = 0.01f * static_cast<float>(n);
    for (const float height : {1e-5f, 0.0f}) {
      soup.add({Vec3(0, y, 0), Vec3(0.5f, y, 0), Vec3(0.25f, y + height, 0)}, 90);
    }
  }
  const PatternQuality after = soup.quality();
  EXPECT_NEAR(after.angle_error_mean_deg, before.angle_error_mean_deg, 0.02);
  EXPECT_NEAR(after.angle_error_share_over_5deg, 0, 2e-4);
  EXPECT_NEAR(after.spacing_error_mean, before.spacing_error_mean, 1e-3);
}

TEST(Quality, OfNothingAndOfTrianglesWithoutAreaIsZero) {
  Soup soup;
  EXPECT_EQ(soup.quality().angle_error_mean_deg, 0);
  soup.add({Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(2, 0, 0)}, 45);
  EXPECT_EQ(soup.quality().angle_error_mean_deg, 0);
  EXPECT_EQ(soup.quality().spacing_error_mean, 0);
}

TEST(Quality, CountsVerticesWithoutAWave) {
  Soup soup;
  soup.add(kLarge, 2);
  soup.add(kSmall, 12);
  EXPECT_EQ(soup.quality().vertices_without_wave, 0u);
  soup.waves.directions[1].setZero();
  soup.waves.directions[5].setZero();
  EXPECT_EQ(soup.quality().vertices_without_wave, 2u);
}

}  // namespace
}  // namespace brindle
