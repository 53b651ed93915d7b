/// Checks of closed meshes.
#pragma once

#include <map>
#include <set>
#include <utility>

#include <gtest/gtest.h>

#include "brindle/mesh.h"

namespace brindle {

/// The directed edges of a mesh, with the number of triangles along each.
inline std::map<std::pair<Index, Index>, int> directed_edges(const Mesh& mesh) {
  std::map<std::pair<Index, Index>, int> edges;
  for (const Triangle& t : mesh.triangles) {
    for (int m = 0; m < 3; ++m) ++edges[{t[m], t[(m + 1) % 3]}];
  }
  return edges;
}

inline std::size_t boundary_edges(const Mesh& mesh) {
  const auto edges = directed_edges(mesh);
  std::size_t count = 0;
  for (const auto& [edge, times] : edges)
    count += edges.contains({edge.second, edge.first}) ? 0 : 1;
  return count;
}

/// Every edge is in two triangles, once in each direction.
inline void expect_closed(const Mesh& mesh) {
  EXPECT_FALSE(mesh.triangles.empty());
  EXPECT_EQ(boundary_edges(mesh), 0u);
  for (const auto& [edge, times] : directed_edges(mesh)) ASSERT_EQ(times, 1);
}

/// Vertices minus edges plus triangles; of a closed mesh.
inline int euler_number(const Mesh& mesh) {
  std::set<Index> vertices;
  for (const Triangle& t : mesh.triangles) vertices.insert(t.begin(), t.end());
  return static_cast<int>(vertices.size()) - static_cast<int>(mesh.triangle_count() / 2);
}

inline float triangle_area_of(const Mesh& mesh, const Triangle& t) {
  const auto& p = mesh.positions;
  return 0.5f * (p[t[1]] - p[t[0]]).cross(p[t[2]] - p[t[0]]).norm();
}

}  // namespace brindle
