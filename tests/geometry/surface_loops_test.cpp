#include <algorithm>
#include <numbers>
#include <string>

#include <gtest/gtest.h>

#include "brindle/geometry/topology.h"
#include "brindle/shapes.h"
#include "brindle/surface.h"

namespace brindle {
namespace {

std::vector<SurfaceLoop> loops_of(const std::string& shape) {
  return surface_loops(make_surface(make_shape(shape)));
}

std::size_t count(const std::vector<SurfaceLoop>& loops, bool boundary) {
  return static_cast<std::size_t>(std::ranges::count_if(
      loops, [&](const SurfaceLoop& loop) { return loop.boundary == boundary; }));
}

TEST(SurfaceLoops, AreAsManyAsTheTopologySays) {
  const auto expect = [](const std::string& shape, std::size_t boundaries, std::size_t handles) {
    const auto loops = loops_of(shape);
    EXPECT_EQ(count(loops, true), boundaries) << shape;
    EXPECT_EQ(count(loops, false), handles) << shape;
  };
  expect("sphere,resolution=6", 0, 0);
  expect("hemisphere,resolution=6", 1, 0);
  expect("plane,resolution=6", 1, 0);
  expect("cylinder,resolution=12", 2, 0);
  expect("tube,resolution=12", 2, 0);
  expect("torus,resolution=24", 0, 2);
  expect("trefoil,resolution=12", 0, 2);
  expect("mobius,resolution=6", 1, 1);
  expect("box,resolution=12", 0, 2);
  expect("pieces,count=3,resolution=4", 2, 2);
  expect("sheets,count=3,resolution=6", 0, 0);  // not a manifold
}

TEST(SurfaceLoops, RunAlongEdgesAndOnce) {
  for (const std::string shape :
       {"torus,resolution=24", "tube,resolution=12", "mobius,resolution=6"}) {
    const Surface surface = make_surface(make_shape(shape));
    for (const SurfaceLoop& loop : surface_loops(surface)) {
      const std::size_t n = loop.vertices.size();
      for (std::size_t i = 0; i < n; ++i) {
        const auto neighbors = surface.neighborhood->of(loop.vertices[i]);
        EXPECT_TRUE(std::ranges::binary_search(neighbors, loop.vertices[(i + 1) % n]));
      }
      std::vector<Index> sorted = loop.vertices;
      std::ranges::sort(sorted);
      EXPECT_EQ(std::ranges::adjacent_find(sorted), sorted.end()) << loop.name;
    }
  }
}

TEST(SurfaceLoops, OfATorusAreShort) {
  const auto loops = loops_of("torus,major=0.7,minor=0.3,resolution=60");
  ASSERT_EQ(loops.size(), 2u);
  const double pi = std::numbers::pi;
  EXPECT_NEAR(loops[0].length, 2 * pi * 0.3, 0.4);
  EXPECT_GT(loops[1].length, 2 * pi * 0.4 - 0.1);
  EXPECT_LT(loops[1].length, 2 * pi * 1.2);
}

TEST(SurfaceLoops, OfBoundariesHaveTheSurfaceOnTheLeft) {
  const Surface surface = make_surface(make_shape("hemisphere,resolution=8"));
  const auto loops = surface_loops(surface);
  ASSERT_EQ(loops.size(), 1u);
  double turned = 0;
  for (std::size_t i = 0; i < loops[0].vertices.size(); ++i) {
    const Vec3& a = surface.mesh.positions[loops[0].vertices[i]];
    const Vec3& b = surface.mesh.positions[loops[0].vertices[(i + 1) % loops[0].vertices.size()]];
    turned += a.x() * b.y() - a.y() * b.x();
  }
  EXPECT_NEAR(turned, 2 * std::numbers::pi, 0.1);  // counter-clockwise from above
  EXPECT_NEAR(loops[0].length, 2 * std::numbers::pi, 0.1);
}

TEST(SurfaceLoops, AtAVertexWhereTwoPiecesTouchKeepApart) {
  Mesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}};
  mesh.triangles = {{0, 1, 2}, {0, 3, 4}};
  const auto loops = surface_loops(make_surface(mesh));
  ASSERT_EQ(count(loops, true), 2u);
  EXPECT_EQ(loops[0].vertices.size(), 3u);
  EXPECT_EQ(loops[1].vertices.size(), 3u);
}

TEST(SurfaceLoops, OfPointsAreNone) {
  Surface surface = make_surface(make_shape("torus,resolution=12"));
  surface.mesh.triangles.clear();
  EXPECT_TRUE(surface_loops(surface).empty());
}

}  // namespace
}  // namespace brindle
