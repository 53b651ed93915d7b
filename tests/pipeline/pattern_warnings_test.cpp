#include "brindle/pattern_warnings.h"

#include <gtest/gtest.h>

#include "brindle/shapes.h"

namespace brindle {
namespace {

bool has(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

TEST(PatternWarnings, AreOfManyBranches) {
  PatternQuality quality;
  quality.branches = 73;
  quality.branch_area_share = 0.1;
  EXPECT_TRUE(quality_warnings({}, quality, 722).empty());
  quality.branch_area_share = 0.11;
  const std::vector<std::string> found = quality_warnings({}, quality, 722);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_TRUE(has(found[0], "in 73 of 722 triangles, on 11 % of the area")) << found[0];
}

TEST(PatternWarnings, AreOfStripesOffTheirFieldInCoarseTriangles) {
  PatternQuality quality;
  quality.coarse_share_over_5deg = 0.25;
  EXPECT_TRUE(quality_warnings({}, quality, 722).empty());
  quality.coarse_share_over_5deg = 0.41;
  const std::vector<std::string> found = quality_warnings({}, quality, 722);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_TRUE(has(found[0], "on 41 % of the area")) << found[0];
}

TEST(PatternWarnings, WavesThatAreTooFineAreToldOnce) {
  PatternQuality quality;
  quality.branches = 700;
  quality.branch_area_share = 0.9;
  quality.coarse_share_over_5deg = 1;
  WaveFigures fine;
  fine.edges_per_period_median = 1;
  EXPECT_EQ(wave_warnings(fine).size(), 1u);
  EXPECT_TRUE(quality_warnings(fine, quality, 722).empty());
}

// Half of the vertices have edges enough, but nearly all of the area lies in long triangles, on
// which a field that turns cannot be followed.
TEST(PatternWarnings, LongTrianglesThatMissTheirFieldAreTold) {
  // A fan of long triangles, and a fine patch beside it.
  Mesh mesh = make_shape("plane,resolution=20");
  for (Vec3& position : mesh.positions) position *= 0.05f;
  const auto middle = static_cast<Index>(mesh.positions.size());
  mesh.positions.push_back({10, 0, 0});
  constexpr int kRim = 24;
  for (int i = 0; i < kRim; ++i) {
    const float angle = static_cast<float>(i) * 6.2831853f / kRim;
    mesh.positions.push_back({10 + 8 * std::cos(angle), 8 * std::sin(angle), 0});
    const Index a = middle + 1 + static_cast<Index>(i);
    const Index b = middle + 1 + static_cast<Index>((i + 1) % kRim);
    mesh.triangles.push_back({middle, a, b});
  }
  const Surface surface = make_surface(std::move(mesh));
  WaveSet waves{surface.mesh.positions, {}, {}};
  for (const Vec3& position : surface.mesh.positions) {
    const float turn = 0.7f * position.x() + 0.4f * position.y();
    waves.directions.push_back({std::cos(turn), std::sin(turn), 0});
    waves.frequencies.push_back(4);
  }
  const StripePattern pattern = stripe_pattern(surface, std::move(waves));
  EXPECT_FALSE(measure_waves(surface, pattern.waves).are_too_fine());
  const std::vector<std::string> found = pattern_warnings(surface, pattern);
  ASSERT_FALSE(found.empty());
  EXPECT_TRUE(has(found.back(), " % of the area")) << found.back();
  EXPECT_LT(static_cast<double>(pattern.quality.branches),
            0.1 * static_cast<double>(surface.mesh.triangle_count()));
}

}  // namespace
}  // namespace brindle
