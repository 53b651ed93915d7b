#include <gtest/gtest.h>

#include "brindle/mesh.h"

namespace brindle {
namespace {

TEST(Append, KeepsCornersAtTheirPlaces) {
  const Mesh other{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}};
  Mesh mesh{{{5, 5, 5}}, {}};
  append(other, mesh);
  append(other, mesh);
  EXPECT_EQ(mesh.positions.size(), 7u);
  EXPECT_EQ(mesh.positions[4], other.positions[0]);
  EXPECT_EQ(mesh.triangles, (std::vector<Triangle>{{1, 2, 3}, {4, 5, 6}}));
}

TEST(Append, MeshesWithOtherOriginsStandWhereTheyStood) {
  Mesh other{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}};
  other.origin = Eigen::Vector3d(5800000, 2, 3);
  Mesh mesh;
  append(other, mesh);
  EXPECT_EQ(mesh.origin, other.origin);
  EXPECT_EQ(mesh.positions, other.positions);
  other.origin.x() += 4.5;
  append(other, mesh);
  EXPECT_EQ(mesh.origin, Eigen::Vector3d(5800000, 2, 3));
  EXPECT_EQ(mesh.positions[4], Vec3(5.5f, 0, 0));
}

}  // namespace
}  // namespace brindle
