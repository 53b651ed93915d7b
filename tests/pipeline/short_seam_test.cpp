#include "brindle/pipeline/short_seam.h"

#include <algorithm>
#include <random>

#include <gtest/gtest.h>

#include "brindle/geometry/topology.h"
#include "brindle/shapes.h"

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

using Neighbors = std::vector<std::vector<Index>>;  ///< numbers of edges at every node

Neighbors edges_at_nodes(const std::vector<SeamEdge>& edges, std::size_t nodes) {
  Neighbors at(nodes);
  for (Index e = 0; e < edges.size(); ++e) {
    for (const Index node : edges[e].nodes) at[node].push_back(e);
  }
  return at;
}

Index other_end(const SeamEdge& edge, Index node) {
  return edge.nodes[0] == node ? edge.nodes[1] : edge.nodes[0];
}

/// Steps from one node to all others.
std::vector<int> distances_from(Index start, const std::vector<SeamEdge>& edges,
                                const Neighbors& at) {
  std::vector<int> distance(at.size(), -1);
  std::vector<Index> queue{start};
  distance[start] = 0;
  for (std::size_t next = 0; next < queue.size(); ++next) {
    for (const Index e : at[queue[next]]) {
      const Index to = other_end(edges[e], queue[next]);
      if (distance[to] >= 0) continue;
      distance[to] = distance[queue[next]] + 1;
      queue.push_back(to);
    }
  }
  return distance;
}

/// Adds a path to the seam, or takes it out where it is in already.
void add_path(Index from, Index to, std::vector<SeamEdge>& edges, const Neighbors& at) {
  const std::vector<int> distance = distances_from(from, edges, at);
  while (to != from) {
    for (const Index e : at[to]) {
      const Index next = other_end(edges[e], to);
      if (distance[next] >= distance[to]) continue;
      edges[e].in_seam = !edges[e].in_seam;
      to = next;
      break;
    }
  }
}

/// The least sum of distances over all ways to pair the ends.
int least_length(const std::vector<Index>& ends, const std::vector<SeamEdge>& edges,
                 const Neighbors& at) {
  constexpr int kFar = 1 << 20;
  std::vector<int> least(std::size_t{1} << ends.size(), kFar);  // of every set of ends
  least[0] = 0;
  std::vector<std::vector<int>> distance;
  for (const Index end : ends) distance.push_back(distances_from(end, edges, at));
  for (std::size_t set = 0; set < least.size(); ++set) {
    if (least[set] == kFar) continue;
    std::size_t i = 0;
    while (i < ends.size() && (set >> i & 1)) ++i;
    for (std::size_t j = i + 1; j < ends.size(); ++j) {
      if (set >> j & 1) continue;
      int& sum = least[set | std::size_t{1} << i | std::size_t{1} << j];
      sum = std::min(sum, least[set] + distance[i][ends[j]]);
    }
  }
  return least.back();
}

TEST(ShortSeam, IsCloseToTheShortestOfAll) {
  const Mesh mesh = make_shape("sphere,resolution=16");
  const std::vector<SeamEdge> plain = edges_of(mesh);
  const Neighbors at = edges_at_nodes(plain, mesh.vertex_count());
  std::mt19937 random(5);
  double sum = 0, least = 0;
  for (int round = 0; round < 10; ++round) {
    std::vector<SeamEdge> edges = plain;
    std::vector<Index> ends;
    for (int i = 0; i < 14; ++i) ends.push_back(static_cast<Index>(random() % mesh.vertex_count()));
    for (std::size_t i = 0; i < ends.size(); i += 2) add_path(ends[i], ends[i + 1], edges, at);
    turn(edges, shortening_turns(edges, mesh.vertex_count(), mesh.triangle_count()));
    const int exact = least_length(ends, edges, at);
    EXPECT_GE(length(edges), static_cast<std::size_t>(exact));
    sum += static_cast<double>(length(edges));
    least += exact;
  }
  EXPECT_GT(least, 500);
  EXPECT_LT(sum, 1.03 * least) << least;
}

/// The first vertex for which this is the greatest.
template <class Height>
Index highest(const Mesh& mesh, const Height& height) {
  return static_cast<Index>(std::ranges::max_element(mesh.positions, {}, height) -
                            mesh.positions.begin());
}

/// Puts all edges near a vertex into the seam that have no node in common, and returns their
/// number.
int crowd_around(Index vertex, std::vector<SeamEdge>& edges, const Neighbors& at) {
  const std::vector<int> distance = distances_from(vertex, edges, at);
  std::vector<std::uint8_t> taken(at.size());
  taken[vertex] = 1;
  int count = 0;
  for (SeamEdge& edge : edges) {
    const auto [a, b] = edge.nodes;
    if (taken[a] || taken[b] || distance[a] > 7 || distance[b] > 7) continue;
    taken[a] = taken[b] = 1;
    edge.in_seam = true;
    ++count;
  }
  return count;
}

// One end of each crowd has no partner there, and the other crowd is farther away than all of its
// own.
TEST(ShortSeam, EndsOfTwoCrowdsThatAreFarApartFindEachOther) {
  const Mesh mesh = make_shape("sphere,resolution=16");
  std::vector<SeamEdge> edges = edges_of(mesh);
  const Neighbors at = edges_at_nodes(edges, mesh.vertex_count());
  const Index top = highest(mesh, [](const Vec3& p) { return p.z(); });
  const Index bottom = highest(mesh, [](const Vec3& p) { return -p.z(); });
  const Index aside = highest(mesh, [](const Vec3& p) { return p.x() - 0.3f * p.z(); });
  const int pairs = crowd_around(top, edges, at) + crowd_around(bottom, edges, at);
  ASSERT_GT(pairs, 80);
  add_path(bottom, aside, edges, at);
  add_path(aside, top, edges, at);
  const int direct = distances_from(bottom, edges, at)[top];
  ASSERT_GT(length(edges), static_cast<std::size_t>(pairs + direct));
  turn(edges, shortening_turns(edges, mesh.vertex_count(), mesh.triangle_count()));
  EXPECT_LE(length(edges), static_cast<std::size_t>(pairs + direct));
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
