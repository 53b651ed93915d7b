#include "brindle/surface.h"

#include <cmath>
#include <limits>
#include <string>

#include <gtest/gtest.h>

#include "brindle/error.h"
#include "brindle/shapes.h"

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

}  // namespace
}  // namespace brindle
