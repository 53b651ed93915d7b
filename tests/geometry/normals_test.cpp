#include "brindle/normals.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "brindle/shapes.h"
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

TEST(Normals, DoNotCancelWhereTrianglesAreWoundAtRandom) {
  Mesh mesh = make_sphere();
  for (std::size_t t = 0; t < mesh.triangle_count(); ++t) {
    if (t * 2654435761u % 7 < 3) std::swap(mesh.triangles[t][0], mesh.triangles[t][1]);
  }
  EXPECT_LT(worst_disagreement(mesh), 0.05f);
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
