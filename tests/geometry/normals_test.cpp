#include "brindle/normals.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "brindle/creases.h"
#include "brindle/shapes.h"
#include "brindle/surface.h"
#include "parametric_meshes.h"
#include "test_meshes.h"

namespace brindle {
namespace {

TEST(Normals, FollowTheRightHandRule) {
  const Mesh mesh{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}};
  EXPECT_EQ(triangle_normal(mesh, mesh.triangles[0]), Vec3(0, 0, 1));
  for (const Vec3& normal : vertex_normals(mesh)) EXPECT_EQ(normal, Vec3(0, 0, 1));
}

TEST(Normals, AreZeroWithoutArea) {
  const Mesh mesh{{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {7, 7, 7}}, {{0, 1, 2}}};
  EXPECT_EQ(triangle_normal(mesh, mesh.triangles[0]), Vec3(0, 0, 0));
  for (const Vec3& normal : vertex_normals(mesh)) EXPECT_EQ(normal, Vec3(0, 0, 0));
}

TEST(Normals, AreWeightedByAngleNotByTheNumberOfTriangles) {
  // The corner of a cube whose three sides are cut into one, two and two triangles.
  const Mesh mesh{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 0}, {0, 1, 1}},
                  {{0, 4, 1}, {0, 2, 4}, {0, 5, 2}, {0, 3, 5}, {0, 1, 3}}};
  const Vec3 expected = Vec3(-1, -1, -1).normalized();
  EXPECT_LT((vertex_normals(mesh)[0] - expected).norm(), 1e-6f);
}

TEST(Normals, OfASphereAreRadial) {
  const Mesh mesh = make_sphere();
  const std::vector<Vec3> normals = vertex_normals(mesh);
  for (std::size_t v = 0; v < normals.size(); ++v) {
    EXPECT_LT((normals[v] - mesh.positions[v]).norm(), 1e-3f);
  }
}

TEST(Normals, SurviveTinyAndHugeMeshes) {
  for (const float scale : {1e-18f, 1e15f}) {
    Mesh mesh = make_sphere({.resolution = 10});
    for (Vec3& position : mesh.positions) position *= scale;
    for (const Vec3& normal : vertex_normals(mesh)) EXPECT_NEAR(normal.norm(), 1, 1e-5f);
  }
}

/// The largest sine of the angle between a vertex's normal and that of a triangle around it.
float worst_disagreement(const Mesh& mesh) {
  const std::vector<Vec3> normals = vertex_normals(mesh);
  float worst = 0;
  for (const Triangle& t : mesh.triangles) {
    const Vec3 normal = triangle_normal(mesh, t);
    for (const Index v : t) {
      worst = std::max(worst, std::sqrt(std::max(0.0f, 1 - std::pow(normal.dot(normals[v]), 2.f))));
    }
  }
  return worst;
}

TEST(Normals, DoNotCancelAtTheSeamOfAMobiusStrip) {
  EXPECT_LT(worst_disagreement(make_mobius()), 0.05f);
}

TEST(Normals, CountAllTrianglesOfAComponentAsWoundAlike) {
  for (const char* shape : {"torus", "sphere", "pieces", "plane"}) {
    const Mesh mesh = make_shape(shape);
    const std::vector<Vec3> expected = vertex_normals(mesh);
    const std::vector<Vec3> found = vertex_normals(with_turned_triangles(mesh));
    for (std::size_t v = 0; v < found.size(); ++v) {
      ASSERT_LT((found[v] - expected[v]).norm(), 1e-6f) << shape << ", vertex " << v;
    }
  }
}

TEST(Normals, PointOutwardsOfAClosedComponentThatIsWoundBothWays) {
  const Mesh sphere = make_sphere();
  Mesh mostly_inwards = sphere;
  for (std::size_t t = 0; t < sphere.triangle_count(); ++t) {
    if (t % 7 != 0) std::swap(mostly_inwards.triangles[t][0], mostly_inwards.triangles[t][1]);
  }
  const std::vector<Vec3> expected = vertex_normals(sphere);
  const std::vector<Vec3> found = vertex_normals(mostly_inwards);
  for (std::size_t v = 0; v < found.size(); ++v) {
    ASSERT_LT((found[v] - expected[v]).norm(), 1e-6f) << v;
  }
}

TEST(Normals, DoNotCancelWhereTrianglesOfAMobiusStripAreWoundAtRandom) {
  EXPECT_LT(worst_disagreement(with_turned_triangles(make_mobius())), 0.05f);
}

// All triangles of a face are wound alike; only its neighbours beyond the creases are not.
TEST(Normals, OfAFaceBehindCreasesAgreeWithItsNeighbours) {
  Mesh cube{
      {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}},
      {{0, 2, 1},
       {0, 3, 2},
       {4, 5, 6},
       {4, 6, 7},
       {0, 1, 5},
       {0, 5, 4},
       {1, 2, 6},
       {1, 6, 5},
       {2, 3, 7},
       {2, 7, 6},
       {3, 0, 4},
       {3, 4, 7}}};
  cube = subdivide(std::move(cube), 3);
  Mesh turned = cube;
  for (Triangle& triangle : turned.triangles) {
    if (triangle_normal(cube, triangle).z() > 0.9f) std::swap(triangle[0], triangle[1]);
  }
  const auto normals = [](Mesh mesh) {
    Creases creases = split_at_creases(mesh, 40);
    EXPECT_FALSE(creases.empty());
    return make_surface(std::move(mesh), std::move(creases)).normals;
  };
  std::vector<Vec3> expected = normals(cube), found = normals(turned);
  // Copies of vertices may be numbered in another order.
  const auto count = [](const std::vector<Vec3>& all, const Vec3& like) {
    return std::ranges::count_if(all, [&](const Vec3& n) { return n.dot(like) > 0.9f; });
  };
  for (const Vec3& axis : {Vec3(0, 0, 1), Vec3(0, 0, -1), Vec3(1, 0, 0)}) {
    EXPECT_EQ(count(found, axis), count(expected, axis)) << axis.transpose();
  }
}

TEST(Normals, AreUnitVectorsOnEveryShape) {
  for (const auto& [name, mesh] : every_shape()) {
    for (const Vec3& normal : vertex_normals(mesh)) {
      ASSERT_NEAR(normal.norm(), 1, 1e-5f) << name;
    }
  }
}

}  // namespace
}  // namespace brindle
