#include "brindle/pipeline/short_seam.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "brindle/surface/shapes.h"
#include "brindle/surface/shared_edges.h"

namespace brindle {
namespace {

std::vector<SeamEdge> edges_of(const Mesh& mesh) {
  std::vector<SeamEdge> edges;
  for (const SharedEdge& edge : shared_edges(mesh.triangles)) {
    const auto vertex = [&](Index corner) { return mesh.triangles[corner / 3][corner % 3]; };
    edges.push_back(
        {{vertex(edge.from[0]), vertex(edge.to[0])}, {edge.from[0] / 3, edge.from[1] / 3}});
  }
  return edges;
}

void turn(std::vector<SeamEdge>& edges, const std::vector<std::uint8_t>& turned) {
  for (SeamEdge& edge : edges) {
    if (turned[edge.triangles[0]] != turned[edge.triangles[1]]) edge.in_seam = !edge.in_seam;
  }
}

std::size_t length(const std::vector<SeamEdge>& edges) {
  return static_cast<std::size_t>(
      std::ranges::count_if(edges, [](const SeamEdge& edge) { return edge.in_seam; }));
}

TEST(ShortSeam, ClosedSeamsVanish) {
  const Mesh mesh = make_shape("sphere,resolution=8");
  std::vector<SeamEdge> edges = edges_of(mesh);
  std::vector<std::uint8_t> upper(mesh.triangle_count());
  for (std::size_t t = 0; t < upper.size(); ++t) {
    upper[t] = mesh.positions[mesh.triangles[t][0]].z() > 0.1f;
  }
  turn(edges, upper);
  ASSERT_GT(length(edges), 20u);
  turn(edges, shortening_turns(edges, mesh.vertex_count(), mesh.triangle_count()));
  EXPECT_EQ(length(edges), 0u);
}

TEST(ShortSeam, EndsStayAndTheWayBetweenThemIsShort) {
  const Mesh mesh = make_shape("sphere,resolution=8");
  std::vector<SeamEdge> edges = edges_of(mesh);
  edges[100].in_seam = true;
  std::vector<std::uint8_t> every_third(mesh.triangle_count());
  for (std::size_t t = 0; t < every_third.size(); t += 3) every_third[t] = 1;
  turn(edges, every_third);
  ASSERT_GT(length(edges), 100u);
  turn(edges, shortening_turns(edges, mesh.vertex_count(), mesh.triangle_count()));
  EXPECT_EQ(length(edges), 1u);
  EXPECT_TRUE(edges[100].in_seam);
}

TEST(ShortSeam, OneThatRunsAroundAHandleStaysThere) {
  const Mesh mesh = make_shape("torus,resolution=32");
  std::vector<SeamEdge> edges = edges_of(mesh);
  for (SeamEdge& edge : edges) {
    const Vec3& a = mesh.positions[edge.nodes[0]];
    const Vec3& b = mesh.positions[edge.nodes[1]];
    // Once around the tube, where it meets the plane y = 0, x > 0.
    edge.in_seam = a.x() > 0 && b.x() > 0 && (a.y() > 0) != (b.y() > 0);
  }
  const std::size_t before = length(edges);
  ASSERT_GT(before, 4u);
  turn(edges, shortening_turns(edges, mesh.vertex_count(), mesh.triangle_count()));
  EXPECT_EQ(length(edges), before);
}

TEST(ShortSeam, OfNothingIsNothing) { EXPECT_TRUE(shortening_turns({}, 0, 0).empty()); }

}  // namespace
}  // namespace brindle
