#include "session/singularities.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <numbers>
#include <unordered_map>
#include <utility>

#include <Eigen/Geometry>
#include <Eigen/SparseCholesky>

#include "brindle/base/elementary.h"
#include "brindle/base/graph.h"
#include "brindle/base/text.h"
#include "brindle/direction_field.h"

namespace brindle::tool {
namespace {

constexpr float kPi = std::numbers::pi_v<float>;
constexpr float kLeastEdges = 3;
constexpr float kSpacing = 0.5f;      // of strokes, relative to the reach
constexpr float kHalfLength = 0.35f;  // of a stroke, relative to the spacing
constexpr float kRadius = 0.6f;       // relative to the spacing
constexpr std::size_t kMostAttractors = 96;

Vec3 barycentre(const Mesh& mesh, std::size_t triangle) {
  const Triangle& t = mesh.triangles[triangle];
  return (mesh.positions[t[0]] + mesh.positions[t[1]] + mesh.positions[t[2]]) / 3;
}

/// The triangle's normal by its corner order.
Vec3 listed_normal(const Mesh& mesh, std::size_t triangle) {
  const Triangle& t = mesh.triangles[triangle];
  const Vec3& a = mesh.positions[t[0]];
  return (mesh.positions[t[1]] - a).cross(mesh.positions[t[2]] - a);
}

/// Whether the corner order disagrees with the vertex normals.
bool is_inside_out(const Surface& surface, std::size_t triangle) {
  const Triangle& t = surface.mesh.triangles[triangle];
  const Vec3 outwards = surface.normals[t[0]] + surface.normals[t[1]] + surface.normals[t[2]];
  return listed_normal(surface.mesh, triangle).dot(outwards) < 0;
}

/// The angle from one vector to another about `normal`.
float angle_between(const Vec3& from, const Vec3& to, const Vec3& normal) {
  return elementary::atan2(normal.dot(from.cross(to)), from.dot(to));
}

using EdgeKey = std::uint64_t;

EdgeKey edge_key(Index a, Index b) { return EdgeKey{std::min(a, b)} << 32 | std::max(a, b); }

/// Edges that a walk between triangles crosses, in the corner order of the triangle before.
using CrossedEdges = std::vector<std::pair<Index, Index>>;

/// The shortest walk over barycentres of triangles not much farther away than the distance of both
/// ends; empty if there is none.
class TriangleWalk {
 public:
  TriangleWalk(const Mesh& mesh, std::size_t from, std::size_t to, float margin) : mesh_(mesh) {
    const Vec3 begin = barycentre(mesh, from), end = barycentre(mesh, to);
    const float farthest = 1.5f * (end - begin).norm() + margin;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
      if ((barycentre(mesh, t) - begin).norm() > farthest) continue;
      for (int m = 0; m < 3; ++m) {
        const Triangle& triangle = mesh.triangles[t];
        sides_[edge_key(triangle[m], triangle[(m + 1) % 3])].push_back(t);
      }
    }
    search(from, to);
  }

  std::vector<std::size_t> triangles;  ///< from first to last
  CrossedEdges crossed;

 private:
  void search(std::size_t from, std::size_t to) {
    /// The triangle before, and the edge to it.
    std::unordered_map<std::size_t, std::pair<std::size_t, std::pair<Index, Index>>> before;
    ShortestWays<float> ways(mesh_.triangles.size());
    ways.offer(static_cast<Index>(from), 0);
    auto nearest = ways.next();
    for (; nearest && nearest->second != to; nearest = ways.next()) {
      const auto [distance, t] = *nearest;
      const Triangle& triangle = mesh_.triangles[t];
      for (int m = 0; m < 3; ++m) {
        const std::pair<Index, Index> edge(triangle[m], triangle[(m + 1) % 3]);
        for (const std::size_t other : sides_[edge_key(edge.first, edge.second)]) {
          const float farther = distance + (barycentre(mesh_, other) - barycentre(mesh_, t)).norm();
          if (ways.offer(static_cast<Index>(other), farther)) before[other] = {t, edge};
        }
      }
    }
    if (!nearest) return;
    for (std::size_t t = to; t != from; t = before[t].first) {
      triangles.push_back(t);
      crossed.push_back(before[t].second);
    }
    triangles.push_back(from);
    std::ranges::reverse(triangles);
    std::ranges::reverse(crossed);
  }

  const Mesh& mesh_;
  std::unordered_map<EdgeKey, std::vector<std::size_t>> sides_;
};

/// Vertices near a walk, sorted by their distance along edges.
std::vector<Index> vertices_near(const Surface& surface, const TriangleWalk& walk, float reach) {
  ShortestWays<float> ways(surface.mesh.vertex_count());
  for (const std::size_t t : walk.triangles) {
    for (const Index v : surface.mesh.triangles[t]) ways.offer(v, 0);
  }
  std::vector<Index> vertices;
  while (const auto nearest = ways.next()) {
    const auto [distance, v] = *nearest;
    vertices.push_back(v);
    for (const Index w : surface.neighborhood->of(v)) {
      const float farther =
          distance + (surface.mesh.positions[w] - surface.mesh.positions[v]).norm();
      if (farther <= reach) ways.offer(w, farther);
    }
  }
  return vertices;
}

/// The rotations of lines at some vertices that make the field smoothest with half turns added
/// across the walk.
class LineTurns {
 public:
  LineTurns(const Surface& surface, std::span<const Vec3> directions, const TriangleWalk& walk,
            int sign)
      : surface_(surface), directions_(directions) {
    for (std::size_t k = 0; k < walk.crossed.size(); ++k) {
      const auto [from, to] = walk.crossed[k];
      const int outside = is_inside_out(surface, walk.triangles[k]) ? -1 : 1;
      jumps_[{from, to}] -= sign * outside;
      jumps_[{to, from}] += sign * outside;
    }
  }

  /// One rotation per vertex of `vertices`; all others stay fixed.
  Eigen::VectorXd solve(const std::vector<Index>& vertices) const {
    std::unordered_map<Index, int> number;
    for (const Index v : vertices) number.emplace(v, static_cast<int>(number.size()));
    std::vector<Eigen::Triplet<double>> entries;
    Eigen::VectorXd wanted = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(vertices.size()));
    for (std::size_t i = 0; i < vertices.size(); ++i) {
      const int row = static_cast<int>(i);
      double degree = 1e-9;  // regularizes unconstrained parts
      for (const Index w : surface_.neighborhood->of(vertices[i])) {
        degree += 1;
        wanted[row] += turn(vertices[i], w);
        if (const auto other = number.find(w); other != number.end()) {
          entries.emplace_back(row, other->second, -1.0);
        }
      }
      entries.emplace_back(row, row, degree);
    }
    Eigen::SparseMatrix<double> matrix(wanted.size(), wanted.size());
    matrix.setFromTriplets(entries.begin(), entries.end());
    return Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>>(matrix).solve(wanted);
  }

 private:
  /// The turn from a vertex to its neighbour.
  double turn(Index from, Index to) const {
    const Vec3 &n = surface_.normals[from], &m = surface_.normals[to];
    const Vec3 carried = Eigen::Quaternionf::FromTwoVectors(n, m) * directions_[from];
    const float shortest = std::remainder(angle_between(carried, directions_[to], m), kPi);
    const auto jump = jumps_.find({from, to});
    return static_cast<double>(
        shortest + (jump == jumps_.end() ? 0.0f : kPi * static_cast<float>(jump->second)));
  }

  const Surface& surface_;
  std::span<const Vec3> directions_;
  std::map<std::pair<Index, Index>, int> jumps_;  ///< half turns
};

/// A short line through a vertex.
FieldStroke stroke_at(const Surface& surface, Index vertex, const Vec3& direction, float spacing,
                      double strength) {
  const Vec3& p = surface.mesh.positions[vertex];
  const Vec3 half = kHalfLength * spacing * direction;
  FieldStroke stroke{{}, static_cast<double>(kRadius * spacing), strength};
  for (const Vec3& point : {Vec3(p - half), p, Vec3(p + half)}) {
    stroke.points.push_back(point.cast<double>() + surface.mesh.origin);
  }
  return stroke;
}

}  // namespace

std::vector<FieldSingularity> field_singularities(const Surface& surface,
                                                  std::span<const CornerPhases> corners,
                                                  std::span<const Vec3> directions) {
  std::vector<FieldSingularity> result;
  const Mesh& mesh = surface.mesh;
  for (std::size_t t = 0; t < std::min(corners.size(), mesh.triangles.size()); ++t) {
    if (corners[t].kind != TriangleKind::field_singularity) continue;
    const Triangle& triangle = mesh.triangles[t];
    const Vec3 normal = listed_normal(mesh, t);
    // From the other side, walk and turn are reversed.
    const int sign = field_index(
        normal, {directions[triangle[0]], directions[triangle[1]], directions[triangle[2]]}, 2);
    result.push_back(
        {t, barycentre(mesh, t), is_inside_out(surface, t) ? Vec3(-normal) : normal, sign});
  }
  return result;
}

std::vector<FieldStroke> strokes_that_move(const FieldSingularity& singularity, std::size_t to,
                                           const Surface& surface, std::span<const Vec3> directions,
                                           double reach, double strength) {
  const Mesh& mesh = surface.mesh;
  const float edge = std::sqrt(singularity.normal.norm());
  const float radius = std::max(static_cast<float>(reach), kLeastEdges * edge);
  const TriangleWalk walk(mesh, singularity.triangle, to, 4 * radius);
  if (walk.triangles.empty()) return {};
  const std::vector<Index> vertices = vertices_near(surface, walk, radius);
  const Eigen::VectorXd turns =
      LineTurns(surface, directions, walk, singularity.sign).solve(vertices);
  const float spacing = kSpacing * radius;
  std::vector<FieldStroke> strokes;
  std::vector<Vec3> used = {barycentre(mesh, to)};
  for (std::size_t i = 0; i < vertices.size() && strokes.size() < kMostAttractors; ++i) {
    const Index v = vertices[i];
    const Vec3& p = mesh.positions[v];
    const bool is_near =
        std::ranges::any_of(used, [&](const Vec3& q) { return (p - q).norm() < spacing; });
    if (is_near || directions[v].isZero(0)) continue;
    used.push_back(p);
    const auto turn = static_cast<float>(turns[static_cast<Eigen::Index>(i)]);
    strokes.push_back(stroke_at(surface, v,
                                Eigen::AngleAxisf(turn, surface.normals[v]) * directions[v],
                                spacing, strength));
  }
  return strokes;
}

std::vector<FieldStroke> with_steering(std::vector<FieldStroke> held,
                                       const std::vector<FieldStroke>& added) {
  const auto middle = [](const FieldStroke& stroke) {
    return stroke.points[stroke.points.size() / 2];
  };
  std::erase_if(held, [&](const FieldStroke& old) {
    return std::ranges::any_of(added, [&](const FieldStroke& stroke) {
      return (middle(stroke) - middle(old)).norm() < old.radius / static_cast<double>(kRadius);
    });
  });
  held.insert(held.end(), added.begin(), added.end());
  return held;
}

Arrival arrival_of(const DroppedSingularity& dropped, const Surface& surface,
                   std::span<const FieldSingularity> after, double reach) {
  const Vec3 to = barycentre(surface.mesh, dropped.to);
  const double edge =
      std::sqrt(static_cast<double>(listed_normal(surface.mesh, dropped.to).norm()));
  const double near = std::max(reach, 2 * edge);
  Arrival arrival;
  bool other_is_there = false;
  for (const FieldSingularity& singularity : after) {
    const auto distance = static_cast<double>((singularity.position - to).norm());
    if (singularity.sign == -dropped.sign) other_is_there |= distance <= near;
    if (singularity.sign != dropped.sign) continue;
    if (arrival.nearest != nullptr && distance >= arrival.distance) continue;
    arrival.nearest = &singularity;
    arrival.distance = distance;
  }
  const bool is_near = arrival.nearest != nullptr && arrival.distance <= near;
  arrival.there = dropped.meets ? !is_near && !other_is_there : is_near;
  const int expected = static_cast<int>(dropped.before) - (dropped.meets ? 2 : 0);
  arrival.others = static_cast<int>(after.size()) - expected;
  return arrival;
}

std::string arrival_words(const DroppedSingularity& dropped, const Arrival& arrival,
                          double diagonal) {
  constexpr const char* kRemedy = "take a smaller radius, more strength, or a shorter way";
  if (arrival.there) {
    const std::string there =
        dropped.meets ? "both singularities are gone" : "the singularity is where you dropped it";
    if (arrival.others == 0) return there;
    return there + formatted("; elsewhere %d %s: take a smaller radius, or a shorter way",
                             std::abs(arrival.others), arrival.others > 0 ? "came" : "went");
  }
  if (dropped.meets) {
    return std::string("the two singularities have not met: the field is smoother with both; ") +
           kRemedy;
  }
  if (arrival.nearest == nullptr || arrival.others < 0) {
    return "the singularity is gone: on its way it met one of the other colour; undo it, and lead "
           "it round that";
  }
  return formatted(
             "the singularity is %.2g %% of the diagonal from where you dropped it, where "
             "the field is smoother; ",
             100 * arrival.distance / diagonal) +
         kRemedy;
}

}  // namespace brindle::tool
