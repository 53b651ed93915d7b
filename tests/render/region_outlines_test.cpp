#include "brindle/region_outlines.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "brindle/error.h"

namespace brindle {
namespace {

/// Positive where the inside is on the left on the screen, whose y points downwards.
double signed_area(const Stroke& loop) {
  double sum = 0;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const auto& a = loop[i];
    const auto& b = loop[(i + 1) % loop.size()];
    sum += static_cast<double>(a.x() * b.y() - a.y() * b.x());
  }
  return -0.5 * sum;
}

/// Smoothly covered from `inner` to `outer` pixels around a middle.
std::vector<float> ring(int side, float inner, float outer) {
  std::vector<float> shares;
  for (int y = 0; y < side; ++y) {
    for (int x = 0; x < side; ++x) {
      const float middle = 0.5f * static_cast<float>(side);
      const float r =
          std::hypot(static_cast<float>(x) + 0.5f - middle, static_cast<float>(y) + 0.5f - middle);
      shares.push_back(std::clamp(outer - r + 0.5f, 0.0f, 1.0f) *
                       std::clamp(r - inner + 0.5f, 0.0f, 1.0f));
    }
  }
  return shares;
}

TEST(RegionOutlines, OfARingAreTwoCircles) {
  const std::vector<Stroke> loops = region_outlines(80, 80, ring(80, 12, 30));
  ASSERT_EQ(loops.size(), 2u);
  double area = 0;
  for (const Stroke& loop : loops) {
    const float radius = (loop[0] - Eigen::Vector2f(40, 40)).norm();
    const float wanted = radius > 20 ? 30.0f : 12.0f;
    for (const auto& p : loop) EXPECT_NEAR((p - Eigen::Vector2f(40, 40)).norm(), wanted, 0.1f);
    area += signed_area(loop);
  }
  EXPECT_NEAR(std::abs(area), std::numbers::pi * (30 * 30 - 12 * 12), 15);
}

TEST(RegionOutlines, ReachTheBorderOfThePicture) {
  const std::vector<Stroke> loops = region_outlines(4, 3, std::vector<float>(12, 1.0f));
  ASSERT_EQ(loops.size(), 1u);
  EXPECT_NEAR(std::abs(signed_area(loops[0])), 12, 0.6);
  EXPECT_TRUE(region_outlines(4, 3, std::vector<float>(12, 0.0f)).empty());
  EXPECT_TRUE(region_outlines(0, 0, {}).empty());
  EXPECT_THROW(region_outlines(4, 3, std::vector<float>(11, 0.0f)), Error);
}

TEST(RegionOutlines, CornersThatTouchAreJoinedOrApartAsTheirMeanSays) {
  const std::vector<float> apart{1, 0, 0, 1}, joined{1, 0.45f, 0.45f, 1};
  EXPECT_EQ(region_outlines(2, 2, apart, 0).size(), 2u);
  EXPECT_EQ(region_outlines(2, 2, joined, 0).size(), 1u);
}

TEST(RegionOutlines, LightIsLinear) {
  Image image(3, 1);
  image.pixels = {{255, 255, 255, 255}, {0, 0, 0, 255}, {188, 188, 188, 255}};
  const std::vector<float> shares = light_shares(image);
  EXPECT_FLOAT_EQ(shares[0], 1);
  EXPECT_FLOAT_EQ(shares[1], 0);
  EXPECT_NEAR(shares[2], 0.5f, 0.01f);
}

}  // namespace
}  // namespace brindle
