#include "brindle/surface.h"

#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "brindle/direction_field.h"
#include "brindle/error.h"
#include "brindle/points.h"
#include "brindle/shapes.h"
#include "brindle/stripe_pattern.h"

namespace brindle {
namespace {

void expect_refused(Mesh mesh, const std::string& named) {
  try {
    make_surface(std::move(mesh));
    ADD_FAILURE() << "taken, though " << named << " is bad";
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find(named + " "), std::string::npos) << error.what();
  }
}

TEST(Surface, RefusesCornersThatAreNoVertices) {
  const Mesh mesh = make_shape("plane,resolution=4");
  const auto vertices = static_cast<Index>(mesh.vertex_count());
  for (const Index corner : {vertices, ~Index{0}}) {
    Mesh bad = mesh;
    bad.triangles[3][1] = bad.triangles[4][2] = corner;
    expect_refused(bad, "triangle 3");
  }
  expect_refused({{}, {{0, 0, 0}}}, "triangle 0");
}

TEST(Surface, RefusesPositionsThatAreNotFinite) {
  for (const float x : {std::nanf(""), std::numeric_limits<float>::infinity()}) {
    Mesh bad = make_shape("plane,resolution=4");
    bad.positions[6].z() = bad.positions[9].x() = x;
    expect_refused(bad, "vertex 6");
  }
}

TEST(Surface, TakesTrianglesWithTwoCornersAlike) {
  Mesh mesh = make_shape("plane,resolution=4");
  const Surface expected = make_surface(mesh);
  mesh.triangles.push_back({3, 3, 4});
  mesh.triangles.push_back({5, 5, 5});
  const Surface surface = make_surface(mesh);
  EXPECT_EQ(surface.neighborhood->neighbors, expected.neighborhood->neighbors);
  for (const Vec3& normal : surface.normals) EXPECT_NEAR(normal.norm(), 1, 1e-5);
}

TEST(Surface, OfNothingIsNothing) { EXPECT_EQ(make_surface({}).neighborhood->node_count(), 0u); }

TEST(Surface, OfAnySizeThatFloatsCanMeasureIsTheSame) {
  const auto quality_at = [](float scale) {
    Mesh mesh = make_shape("torus,resolution=20");
    for (Vec3& p : mesh.positions) p *= scale;
    const Surface surface = make_surface(std::move(mesh));
    const DirectionField field = projected_direction_field({1, 2, 3}, surface.normals);
    return stripe_pattern(surface, field, 4 / scale).quality;
  };
  const PatternQuality at_one = quality_at(1);
  for (const float scale : {1e-8f, 1e-4f, 1e4f, 1e8f}) {
    const PatternQuality quality = quality_at(scale);
    EXPECT_NEAR(quality.angle_error_mean_deg, at_one.angle_error_mean_deg, 0.1) << scale;
    EXPECT_NEAR(quality.spacing_error_mean, at_one.spacing_error_mean, 0.01) << scale;
  }
}

TEST(Surface, OfASizeThatFloatsCannotMeasureIsRefusedWithTheRemedy) {
  const std::pair<float, const char*> sizes[] = {
      {1e-20f, "multiplied by 1e2"}, {1e-12f, "multiplied by 1e1"}, {1e12f, "multiplied by 1e-1"}};
  for (const auto& [scale, remedy] : sizes) {
    Mesh mesh = make_shape("torus,resolution=20");
    for (Vec3& p : mesh.positions) p *= scale;
    const std::vector<Vec3> points = mesh.positions;
    const auto expect_refused = [remedy = remedy](const auto& make) {
      try {
        make();
        ADD_FAILURE() << "taken, without " << remedy;
      } catch (const Error& error) {
        EXPECT_NE(std::string(error.what()).find(remedy), std::string::npos) << error.what();
      }
    };
    expect_refused([&] { make_surface(mesh); });
#ifdef BRINDLE_HAS_NANOFLANN
    expect_refused([&] { make_point_surface(make_point_cloud(points).cloud); });
#endif
  }
}

}  // namespace
}  // namespace brindle
