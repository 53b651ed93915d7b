#include <gtest/gtest.h>

#include "brindle/geometry/measures.h"
#include "brindle/geometry/topology.h"
#include "brindle/shapes.h"

namespace brindle {
namespace {

using Edges = std::vector<std::array<Index, 2>>;

Edges features_of(const Mesh& mesh, float angle_deg) {
  return feature_edges(mesh, mesh_edges(mesh, vertex_neighborhood(mesh)), angle_deg);
}

/// Two triangles that share the edge 1-2 and bend there by 90 degrees, the second wound either way.
Mesh folded(bool wound_alike) {
  return {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0.5f, 0.5f, 1}},
          {{0, 1, 2}, wound_alike ? Triangle{2, 1, 3} : Triangle{1, 2, 3}}};
}

TEST(FeatureEdges, OfAPlaneAreItsBoundary) {
  const Mesh plane = make_shape("plane,resolution=8");
  for (const auto& [a, b] : features_of(plane, 1)) {
    const Vec3 middle = (plane.positions[a] + plane.positions[b]) / 2;
    EXPECT_GT(middle.cwiseAbs().maxCoeff(), 0.85f);
  }
  EXPECT_FALSE(features_of(plane, 1).empty());
}

TEST(FeatureEdges, BendByMoreThanTheAngleHoweverTrianglesAreWound) {
  for (const bool wound_alike : {true, false}) {
    EXPECT_EQ(features_of(folded(wound_alike), 80).size(), 5u);
    EXPECT_EQ(features_of(folded(wound_alike), 100).size(), 4u);
  }
}

TEST(FeatureEdges, AreNotOnSmoothClosedSurfaces) {
  EXPECT_TRUE(features_of(make_shape("torus,resolution=60"), 20).empty());
}

TEST(FeatureEdges, IncludeThoseOfManyTriangles) {
  const Mesh sheets = make_shape("sheets,count=3,resolution=6");
  std::size_t on_axis = 0;
  for (const auto& [a, b] : features_of(sheets, 170)) {
    on_axis += sheets.positions[a].head<2>().norm() + sheets.positions[b].head<2>().norm() < 1e-5f;
  }
  EXPECT_GT(on_axis, 5u);
}

}  // namespace
}  // namespace brindle
