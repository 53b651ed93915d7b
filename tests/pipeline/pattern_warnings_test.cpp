#include "brindle/pattern_warnings.h"

#include <gtest/gtest.h>

#include "brindle/shapes.h"
#include "brindle/smooth_field.h"
#include "brindle/texture_pattern.h"

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

TEST(PatternWarnings, AreOfMotifsThatAreLeftOut) {
  const Surface torus = make_surface(make_shape("torus,resolution=60"));
  const auto broken = [&](const DirectionField& field) {
    const TexturePattern pattern = texture_pattern(torus, field, 4);
    return broken_tiles(torus.mesh.triangles, pattern.waves, {});
  };
  const std::size_t triangles = torus.mesh.triangle_count();
  const BrokenTiles few = broken(smooth_direction_field(torus));
  EXPECT_GT(few.whole_share(triangles), 0.5);
  EXPECT_TRUE(tile_warnings(few, triangles).empty());
  std::vector<Vec3> noise;
  for (std::size_t v = 0; v < torus.normals.size(); ++v) {
    const auto angle = static_cast<float>(v * 2654435761u % 1000);
    noise.push_back({std::cos(angle), std::sin(angle), std::cos(3 * angle)});
  }
  const BrokenTiles all = broken(tangent_directions(noise, torus.normals));
  EXPECT_LT(all.whole_share(triangles), 0.1);
  const std::vector<std::string> found = tile_warnings(all, triangles);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_TRUE(has(found[0], "the others are left out")) << found[0];
  EXPECT_EQ(BrokenTiles().whole_share(triangles), 1);
}

TEST(PatternWarnings, RemediesNameTheTotalOfSubdivisions) {
  PatternQuality branched, off;
  branched.branches = 700;
  branched.branch_area_share = 0.9;
  off.coarse_share_over_5deg = 1;
  WarningWords words;
  words.subdivided = 2;
  words.fewer = "ask for less";
  const auto warned = [&](const PatternQuality& quality, double edges) {
    WaveMetrics metrics;
    metrics.edges_per_period_median = edges;
    const std::vector<std::string> found = quality_warnings(metrics, quality, 722, words);
    EXPECT_EQ(found.size(), 1u);
    EXPECT_TRUE(has(found.at(0), "ask for less")) << found[0];
    return found.at(0);
  };
  for (const PatternQuality& quality : {branched, off}) {
    EXPECT_TRUE(has(warned(quality, 1.5), "subdivide the mesh, times: 3"));
    EXPECT_TRUE(has(warned(quality, 0.1), "subdivide the mesh, times: 7"));
    EXPECT_FALSE(has(warned(quality, 0.01), "subdivide")) << "too many times";
  }
  EXPECT_FALSE(has(warned(branched, 2.1), "subdivide")) << "the mesh is fine enough";
  EXPECT_TRUE(has(warned(off, 2.1), "subdivide the mesh, times: 3"));
  words.subdivide = "";
  EXPECT_FALSE(has(warned(off, 1.5), "subdivide")) << "points have no triangles";
}

TEST(PatternWarnings, TexturesAreWarnedOfTheWorseOfTheirPatterns) {
  const Surface surface = make_surface(make_shape("plane,resolution=5"));
  TexturePattern texture = texture_pattern(
      surface, projected_direction_field({1, 0, 0}, surface.normals), 2, TextureOptions{});
  EXPECT_TRUE(pattern_warnings(surface, texture).empty());
  texture.v.quality.branch_area_share = 0.3;
  ASSERT_EQ(pattern_warnings(surface, texture).size(), 1u);
  EXPECT_TRUE(has(pattern_warnings(surface, texture)[0], "on 30 % of the area"));
}

// Waves that turn nowhere are exact on any mesh.
TEST(PatternWarnings, ExactWavesAreFineOnCoarseMeshes) {
  for (const char* shape : {"plane,resolution=5", "cylinder,resolution=8"}) {
    const Surface surface = make_surface(make_shape(shape));
    const StripePattern pattern = stripe_pattern(
        surface, {surface.mesh.positions, projected_direction_field({0, 0, 1}, surface.normals),
                  constant_frequency_field(40, surface.mesh.vertex_count())});
    EXPECT_LT(measure_waves(surface, pattern.waves).edges_per_period_median, 2) << shape;
    EXPECT_TRUE(quality_warnings(measure_waves(surface, pattern.waves), pattern.quality,
                                 surface.mesh.triangle_count())
                    .empty())
        << shape;
  }
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
  const std::vector<std::string> found = pattern_warnings(surface, pattern);
  ASSERT_FALSE(found.empty());
  EXPECT_TRUE(has(found.back(), " % of the area")) << found.back();
  EXPECT_LT(static_cast<double>(pattern.quality.branches),
            0.1 * static_cast<double>(surface.mesh.triangle_count()));
}

}  // namespace
}  // namespace brindle
