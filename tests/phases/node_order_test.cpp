#include <algorithm>
#include <random>

#include <gtest/gtest.h>

#include "brindle/phases/coloring.h"
#include "phase_graphs.h"

namespace brindle {
namespace {

TEST(BreadthFirstOrder, IsAPermutationOfAllNodes) {
  const auto surface =
      testing_support::wavy_surface("pieces,count=3,resolution=6", Vec3(0, 1, 0), 5);
  std::vector<Index> order = breadth_first_order(*surface.neighborhood);
  std::ranges::sort(order);
  for (Index node = 0; node < order.size(); ++node) ASSERT_EQ(order[node], node);
  EXPECT_EQ(order.size(), surface.neighborhood->node_count());
}

TEST(BreadthFirstOrder, BringsNeighborsTogether) {
  // A sphere whose vertices are numbered at random.
  Mesh mesh = make_shape("sphere,resolution=30");
  std::vector<Index> shuffled(mesh.vertex_count());
  for (Index i = 0; i < shuffled.size(); ++i) shuffled[i] = i;
  std::shuffle(shuffled.begin(), shuffled.end(), std::mt19937(1));
  for (Triangle& triangle : mesh.triangles) {
    for (Index& vertex : triangle) vertex = shuffled[vertex];
  }
  const Adjacency adjacency = vertex_neighborhood(mesh);
  const std::vector<Index> order = breadth_first_order(adjacency);
  std::vector<Index> place(order.size());
  for (Index p = 0; p < order.size(); ++p) place[order[p]] = p;
  Index farthest = 0;
  for (Index i = 0; i < order.size(); ++i) {
    for (const Index j : adjacency.of(i)) {
      farthest = std::max(farthest, place[i] > place[j] ? place[i] - place[j] : 0);
    }
  }
  EXPECT_LT(farthest, order.size() / 10);
}

}  // namespace
}  // namespace brindle
