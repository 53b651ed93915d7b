#include "brindle/render/outer_side.h"

#include <algorithm>
#include <cstdint>
#include <vector>

#include <Eigen/Geometry>

#include "brindle/base/graph.h"
#include "brindle/base/random.h"
#include "brindle/base/standard.h"

namespace brindle {
namespace {

/// A hash of an edge.
std::uint64_t number_of_edge(Index lower, Index upper) {
  return mixed_bits((std::uint64_t{lower} << 32 | upper) + kRandomStep);
}

/// Whether every edge is used equally often in both directions: signed edge hashes then cancel.
/// Another mesh passes with probability 2^-64.
bool is_closed(const Mesh& mesh) {
  std::uint64_t sum = 0;
  for (const Triangle& t : mesh.triangles) {
    for (int m = 0; m < 3; ++m) {
      const Index from = t[m], to = t[(m + 1) % 3];
      sum += from < to ? number_of_edge(from, to) : -number_of_edge(to, from);
    }
  }
  return sum == 0;
}

/// A representative vertex of the connected component, for every vertex.
std::vector<Index> connected_parts(const Mesh& mesh) {
  MergedSets parts(mesh.vertex_count());
  for (const Triangle& t : mesh.triangles) {
    parts.merge(t[0], t[1]);
    parts.merge(t[0], t[2]);
  }
  std::vector<Index> part_of(mesh.vertex_count());
  for (Index v = 0; v < part_of.size(); ++v) part_of[v] = parts.of(v);
  return part_of;
}

}  // namespace

HiddenSide hidden_side(const Mesh& mesh) {
  if (mesh.triangles.empty() || !is_closed(mesh)) return HiddenSide::none;
  const std::vector<Index> parts = connected_parts(mesh);
  const Vec3 near = mesh.positions[mesh.triangles[0][0]];
  std::vector<double> volumes(mesh.vertex_count());
  for (const Triangle& t : mesh.triangles) {
    const auto corner = [&](int m) -> Eigen::Vector3d {
      return (mesh.positions[t[m]] - near).cast<double>();
    };
    volumes[parts[t[0]]] += corner(0).dot(corner(1).cross(corner(2)));
  }
  const auto all_of_sign = [&](double sign) {
    return ranges::all_of(mesh.triangles,
                          [&](const Triangle& t) { return sign * volumes[parts[t[0]]] > 0; });
  };
  if (all_of_sign(1)) return HiddenSide::back;
  return all_of_sign(-1) ? HiddenSide::front : HiddenSide::none;
}

}  // namespace brindle
