#include "brindle/shapes/delaunay_flips.h"

#include <algorithm>
#include <array>
#include <utility>

#include <Eigen/Geometry>

#include "brindle/base/parallel.h"
#include "brindle/geometry/topology.h"
#include "brindle/normals.h"

namespace brindle {
namespace {

Eigen::Vector3d position_at(const Mesh& mesh, Index half_edge) {
  return mesh.positions[vertex_at(mesh.triangles, half_edge)].cast<double>();
}

/// The cotangent of the angle opposite a half-edge.
double opposite_cotangent(const Mesh& mesh, Index h) {
  const Eigen::Vector3d apex = position_at(mesh, previous_in_triangle(h));
  const Eigen::Vector3d a = position_at(mesh, h) - apex;
  const Eigen::Vector3d b = position_at(mesh, next_in_triangle(h)) - apex;
  return a.dot(b) / std::max(a.cross(b).norm(), 1e-30);
}

/// Whether an edge connects the origin of `h` with vertex `to`.
bool has_edge(const Mesh& mesh, const std::vector<Index>& twins, Index h, Index to) {
  const Index start = h;
  do {
    if (vertex_at(mesh.triangles, next_in_triangle(h)) == to) return true;
    h = twins[previous_in_triangle(h)];
  } while (h != start);
  return false;
}

/// Whether the flipped triangles face the same side as the old ones.
bool flip_keeps_side(const Mesh& mesh, const Triangle& one, const Triangle& other, Index h,
                     Index twin) {
  const Vec3 old = triangle_normal(mesh, mesh.triangles[h / 3]) +
                   triangle_normal(mesh, mesh.triangles[twin / 3]);
  return triangle_normal(mesh, one).dot(old) > 0.2f && triangle_normal(mesh, other).dot(old) > 0.2f;
}

/// Flips the edge if that is valid; returns whether it did.
bool flip(Mesh& mesh, std::vector<Index>& twins, Index h) {
  const Index t = twins[h];
  const Index h_next = next_in_triangle(h), h_previous = previous_in_triangle(h);
  const Index t_next = next_in_triangle(t), t_previous = previous_in_triangle(t);
  const Index a = vertex_at(mesh.triangles, h), b = vertex_at(mesh.triangles, t);
  const Index c = vertex_at(mesh.triangles, h_previous), d = vertex_at(mesh.triangles, t_previous);
  const Triangle one = {c, a, d}, other = {d, b, c};
  if (c == d || has_edge(mesh, twins, h_previous, d)) return false;
  if (!flip_keeps_side(mesh, one, other, h, t)) return false;
  const std::array<Index, 4> outside = {twins[h_previous], twins[t_next], twins[t_previous],
                                        twins[h_next]};
  const Index first = 3 * (h / 3), second = 3 * (t / 3);
  mesh.triangles[h / 3] = one;
  mesh.triangles[t / 3] = other;
  const std::array<std::pair<Index, Index>, 5> pairs = {{{first, outside[0]},
                                                         {first + 1, outside[1]},
                                                         {second, outside[2]},
                                                         {second + 1, outside[3]},
                                                         {first + 2, second + 2}}};
  for (const auto& [inner, outer] : pairs) {
    twins[inner] = outer;
    twins[outer] = inner;
  }
  return true;
}

}  // namespace

void flip_to_delaunay(Mesh& mesh, std::vector<Index>& twins, int rounds, const Progress& progress) {
  // The cotangents add up to less than 0 if the angles exceed 180 degrees in total. The margin
  // avoids cycles of flips for cocircular corners.
  constexpr double kLimit = -1e-3;
  for (int round = 0; round < rounds; ++round) {
    bool flipped = false;
    for (Index h = 0; h < twins.size(); ++h) {
      if (h % kReportSlice == 0) progress.tick();
      const Index twin = twins[h];
      if (h < twin && opposite_cotangent(mesh, h) + opposite_cotangent(mesh, twin) < kLimit) {
        flipped = flip(mesh, twins, h) || flipped;
      }
    }
    if (!flipped) return;
  }
}

}  // namespace brindle
