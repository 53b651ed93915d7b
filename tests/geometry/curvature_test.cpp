#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "brindle/base/parallel.h"
#include "brindle/geometry/topology.h"
#include "brindle/normals.h"
#include "parametric_meshes.h"

namespace brindle {
namespace {

std::vector<PrincipalCurvature> curvatures(const Mesh& mesh) {
  return principal_curvatures(mesh.positions, vertex_normals(mesh), vertex_neighborhood(mesh));
}

TEST(Curvature, OfASphereIsOneOverItsRadius) {
  for (const auto& c : curvatures(make_sphere({.radius = 0.25f}))) {
    EXPECT_NEAR(c.maximum, 4, 0.04);
    EXPECT_NEAR(c.minimum, 4, 0.04);
  }
}

TEST(Curvature, OfAPlaneIsZero) {
  for (const auto& c : curvatures(make_plane({.resolution = 20}))) {
    EXPECT_NEAR(c.maximum, 0, 1e-6);
    EXPECT_NEAR(c.minimum, 0, 1e-6);
    EXPECT_NEAR(c.maximum_direction.norm(), 1, 1e-6);
  }
}

TEST(Curvature, OfACylinderIsAcrossItsAxis) {
  const Mesh mesh = make_cylinder({.radius = 0.5f});
  const auto all = curvatures(mesh);
  for (std::size_t v = 0; v < all.size(); ++v) {
    if (std::abs(mesh.positions[v][2]) > 0.98f) continue;  // borders see one side only
    EXPECT_NEAR(all[v].maximum, 2, 0.02);
    EXPECT_NEAR(all[v].minimum, 0, 0.02);
    EXPECT_NEAR(std::abs(all[v].minimum_direction[2]), 1, 1e-4);
    EXPECT_NEAR(all[v].maximum_direction.dot(all[v].minimum_direction), 0, 1e-6);
  }
}

TEST(Curvature, OfATorusMatchesItsFormula) {
  const float R = 0.7f, r = 0.3f;
  const Mesh mesh = make_torus({.major = R, .minor = r});
  const auto all = curvatures(mesh);
  for (std::size_t v = 0; v < all.size(); ++v) {
    const Vec3& p = mesh.positions[v];
    const float ring = std::hypot(p[0], p[1]);
    const float along = (ring - R) / r / ring;  // cos(theta) / (R + r cos(theta))
    EXPECT_NEAR(all[v].maximum, 1 / r, 0.02);
    EXPECT_NEAR(all[v].minimum, along, 0.02);
    const Vec3 ring_direction = Vec3(-p[1], p[0], 0) / ring;
    EXPECT_NEAR(std::abs(all[v].minimum_direction.dot(ring_direction)), 1, 1e-3);
  }
}

TEST(Curvature, ChangesSignAndNothingElseWithTheWinding) {
  Mesh mesh = make_torus({.resolution = 60});
  const auto before = curvatures(mesh);
  for (Triangle& t : mesh.triangles) std::swap(t[1], t[2]);
  const auto after = curvatures(mesh);
  for (std::size_t v = 0; v < before.size(); ++v) {
    EXPECT_NEAR(after[v].maximum, -before[v].maximum, 1e-4);
    EXPECT_NEAR(after[v].minimum, -before[v].minimum, 1e-4);
    EXPECT_NEAR(std::abs(after[v].maximum_direction.dot(before[v].maximum_direction)), 1, 1e-5);
  }
}

TEST(Curvature, TurnsWithTheMesh) {
  Mesh mesh = make_torus({.resolution = 60});
  const auto before = curvatures(mesh);
  const Eigen::Matrix3f turn =
      Eigen::AngleAxisf(1.1f, Vec3(1, 2, 3).normalized()).toRotationMatrix();
  for (Vec3& p : mesh.positions) p = turn * p + Vec3(0.5f, -1, 2);
  const auto after = curvatures(mesh);
  for (std::size_t v = 0; v < before.size(); ++v) {
    EXPECT_NEAR(after[v].maximum, before[v].maximum, 1e-3);
    EXPECT_NEAR(std::abs(after[v].maximum_direction.dot(turn * before[v].maximum_direction)), 1,
                1e-4);
  }
}

TEST(Curvature, IsNotFooledByNeighboursWoundTheOtherWay) {
  for (const auto& c : curvatures(make_mobius())) {
    EXPECT_LT(std::abs(c.maximum), 4) << "the strip bends gently, even where it is joined";
  }
}

TEST(Curvature, IsZeroAtLonelyVertices) {
  const Mesh mesh{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {5, 5, 5}}, {{0, 1, 2}}};
  const auto all = curvatures(mesh);
  EXPECT_EQ(all[3].maximum_direction, Vec3(0, 0, 0));
  EXPECT_EQ(all[3].maximum, 0);
}

TEST(Curvature, IsTheSameWithOneThreadAndMany) {
  const Mesh mesh = make_torus();
  const auto many = curvatures(mesh);
  const ThreadLimit limit(1);
  const auto one = curvatures(mesh);
  for (std::size_t v = 0; v < one.size(); ++v) {
    ASSERT_EQ(one[v].maximum, many[v].maximum);
    ASSERT_EQ(one[v].maximum_direction, many[v].maximum_direction);
  }
}

}  // namespace
}  // namespace brindle
