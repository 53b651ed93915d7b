#include "brindle/geometry/topology.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <utility>

#include <Eigen/Geometry>

#include "brindle/base/parallel.h"
#include "brindle/normals.h"

namespace brindle {
namespace {

using Point = Eigen::Vector3d;

/// Whether each vertex is reached by one walk around it.
bool fans_are_single(const Mesh& mesh, const HalfEdges& edges, const Progress& progress) {
  std::vector<Index> valence(mesh.vertex_count(), 0);
  std::vector<Index> start(mesh.vertex_count(), 0);
  reported_for(edges.twins.size(), progress.part(0, 0.3), [&](std::size_t i) {
    const auto h = static_cast<Index>(i);
    const Index v = HalfEdges::origin(mesh, h);
    ++valence[v];
    start[v] = h;
  });
  const Progress walking = progress.part(0.3, 1);
  for (std::size_t v = 0; v < valence.size(); ++v) {
    if (v % kReportSlice == 0) {
      walking.report(static_cast<double>(v) / static_cast<double>(valence.size()));
    }
    if (valence[v] == 0) continue;
    Index walked = 0;
    Index h = start[v];
    do {
      h = edges.twins[HalfEdges::previous(h)];
      ++walked;
    } while (h != start[v]);
    if (walked != valence[v]) return false;
  }
  return true;
}

Point position(const Mesh& mesh, Index half_edge) {
  return mesh.positions[HalfEdges::origin(mesh, half_edge)].cast<double>();
}

/// The cotangent of the angle opposite of a half-edge, in its triangle.
double opposite_cotangent(const Mesh& mesh, Index h) {
  const Point apex = position(mesh, HalfEdges::previous(h));
  const Point a = position(mesh, h) - apex;
  const Point b = position(mesh, HalfEdges::next(h)) - apex;
  return a.dot(b) / std::max(a.cross(b).norm(), 1e-30);
}

/// Whether an edge runs from the origin of `h` to vertex `to`.
bool has_edge(const Mesh& mesh, const HalfEdges& edges, Index h, Index to) {
  const Index start = h;
  do {
    if (HalfEdges::origin(mesh, HalfEdges::next(h)) == to) return true;
    h = edges.twins[HalfEdges::previous(h)];
  } while (h != start);
  return false;
}

/// Whether the two triangles of the flipped edge would look the same way as those of the old one.
bool flip_keeps_side(const Mesh& mesh, const Triangle& one, const Triangle& other, Index h,
                     Index twin) {
  const Vec3 old = triangle_normal(mesh, mesh.triangles[h / 3]) +
                   triangle_normal(mesh, mesh.triangles[twin / 3]);
  return triangle_normal(mesh, one).dot(old) > 0.2f && triangle_normal(mesh, other).dot(old) > 0.2f;
}

bool flip(Mesh& mesh, HalfEdges& edges, Index h) {
  const Index t = edges.twins[h];
  const Index h_next = HalfEdges::next(h), h_previous = HalfEdges::previous(h);
  const Index t_next = HalfEdges::next(t), t_previous = HalfEdges::previous(t);
  const Index a = HalfEdges::origin(mesh, h), b = HalfEdges::origin(mesh, t);
  const Index c = HalfEdges::origin(mesh, h_previous), d = HalfEdges::origin(mesh, t_previous);
  const Triangle one = {c, a, d}, other = {d, b, c};
  if (c == d || has_edge(mesh, edges, h_previous, d)) return false;
  if (!flip_keeps_side(mesh, one, other, h, t)) return false;
  const std::array<Index, 4> outside = {edges.twins[h_previous], edges.twins[t_next],
                                        edges.twins[t_previous], edges.twins[h_next]};
  const Index first = 3 * (h / 3), second = 3 * (t / 3);
  mesh.triangles[h / 3] = one;
  mesh.triangles[t / 3] = other;
  const std::array<std::pair<Index, Index>, 5> pairs = {{{first, outside[0]},
                                                         {first + 1, outside[1]},
                                                         {second, outside[2]},
                                                         {second + 1, outside[3]},
                                                         {first + 2, second + 2}}};
  for (const auto& [inner, outer] : pairs) {
    edges.twins[inner] = outer;
    edges.twins[outer] = inner;
  }
  return true;
}

}  // namespace

std::optional<HalfEdges> half_edges(const Mesh& mesh, const Progress& progress) {
  struct Directed {
    std::uint64_t key;  ///< smaller end, then larger end
    Index half_edge;
  };
  std::vector<Directed> directed(3 * mesh.triangle_count());
  reported_for(directed.size(), progress.part(0, 0.1), [&](std::size_t i) {
    const auto h = static_cast<Index>(i);
    const std::uint64_t a = HalfEdges::origin(mesh, h);
    const std::uint64_t b = HalfEdges::origin(mesh, HalfEdges::next(h));
    directed[h] = {std::min(a, b) << 32 | std::max(a, b), h};
  });
  reported_sort(directed.begin(), directed.end(), progress.part(0.1, 0.7),
                [](const Directed& x, const Directed& y) {
                  return std::pair(x.key, x.half_edge) < std::pair(y.key, y.half_edge);
                });
  progress.report(0.7);
  HalfEdges edges;
  edges.twins.resize(directed.size());
  for (std::size_t i = 0; i < directed.size(); i += 2) {
    if (i % kReportSlice == 0) {
      const double done = static_cast<double>(i) / static_cast<double>(directed.size());
      progress.report(0.7 + 0.1 * done);
    }
    if (i + 1 == directed.size() || directed[i].key != directed[i + 1].key) return std::nullopt;
    if (i + 2 < directed.size() && directed[i + 2].key == directed[i].key) return std::nullopt;
    const Index h = directed[i].half_edge, t = directed[i + 1].half_edge;
    if (HalfEdges::origin(mesh, h) == HalfEdges::origin(mesh, t)) return std::nullopt;
    edges.twins[h] = t;
    edges.twins[t] = h;
  }
  if (!fans_are_single(mesh, edges, progress.part(0.8, 1))) return std::nullopt;
  return edges;
}

void flip_to_delaunay(Mesh& mesh, HalfEdges& edges, int rounds, const Progress& progress) {
  // The cotangents of two angles add up to less than 0 if the angles add up to more than 180
  // degrees. The margin keeps cocircular corners from flipping to and fro.
  constexpr double kLimit = -1e-3;
  for (int round = 0; round < rounds; ++round) {
    bool flipped = false;
    const Progress of_round =
        progress.part(static_cast<double>(round) / rounds, static_cast<double>(round + 1) / rounds);
    reported_for(edges.twins.size(), of_round, [&](std::size_t i) {
      const auto h = static_cast<Index>(i);
      const Index twin = edges.twins[h];
      if (h < twin && opposite_cotangent(mesh, h) + opposite_cotangent(mesh, twin) < kLimit) {
        flipped = flip(mesh, edges, h) || flipped;
      }
    });
    if (!flipped) return;
  }
}

}  // namespace brindle
