#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <numbers>

#include <Eigen/Geometry>

#include "brindle/base/parallel.h"
#include "brindle/base/standard.h"
#include "brindle/geometry/normals_around.h"
#include "brindle/geometry/winding.h"

namespace brindle {
namespace {

/// Contribution of an adjacent triangle to a vertex normal.
struct Corner {
  Vec3 normal;
  float angle;  ///< radians, at the vertex
  Index next;   ///< the other corners, in the triangle's winding
  Index previous;
};

/// Zero only for the zero vector; Eigen's `normalized` may lose tiny vectors.
Vec3 unit(const Vec3& v) {
  const double length = v.cast<double>().norm();
  return length > 0 ? (v.cast<double>() / length).cast<float>().eval() : Vec3::Zero();
}

/// Area vector: the normal times twice the area.
Eigen::Vector3d doubled_area(const Eigen::Vector3d& a, const Eigen::Vector3d& b,
                             const Eigen::Vector3d& c) {
  return (b - a).cross(c - a);
}

/// atan2(y, x) for y >= 0 and not both zero, exact to the last digit or two: Cephes' atan, inlined.
double angle_of(double y, double x) {
  using std::numbers::pi;
  const double width = std::abs(x);
  const bool is_steep = y > width;
  const double small = is_steep ? width : y, large = is_steep ? y : width;
  const bool is_diagonal = small > 0.66 * large;
  const double t = (is_diagonal ? small - large : small) / (is_diagonal ? small + large : large);
  const double z = t * t;
  const double p = (((-8.750608600031904122785e-1 * z - 1.615753718733365076637e1) * z -
                     7.500855792314704667340e1) *
                        z -
                    1.228866684490136173410e2) *
                       z -
                   6.485021904942025371773e1;
  const double q = ((((z + 2.485846490142306297962e1) * z + 1.650270098316988542046e2) * z +
                     4.328810604912902668951e2) *
                        z +
                    4.853903996359136964868e2) *
                       z +
                   1.945506571482613964425e2;
  double angle = t + t * (z * p / q);
  if (is_diagonal) angle += pi / 4;
  if (is_steep) angle = pi / 2 - angle;
  return x < 0 ? pi - angle : angle;
}

TriangleAngles angles_of(const Mesh& mesh, const Triangle& triangle) {
  std::array<Eigen::Vector3d, 3> p, edge;
  for (int c = 0; c < 3; ++c) p[c] = mesh.positions[triangle[c]].cast<double>();
  for (int c = 0; c < 3; ++c) edge[c] = p[(c + 1) % 3] - p[c];
  const Eigen::Vector3d cross = doubled_area(p[0], p[1], p[2]);
  const double area = cross.norm();
  if (!(area > 0)) return {Vec3::Zero(), {}};
  TriangleAngles result{(cross / area).cast<float>(), {}};
  for (int c = 0; c < 3; ++c) {
    result.angle[c] = static_cast<float>(angle_of(area, -edge[c].dot(edge[(c + 2) % 3])));
  }
  return result;
}

Corner corner_at(const Triangle& triangle, const TriangleAngles& angles, Index vertex,
                 bool is_turned) {
  const int c = corner_of(triangle, vertex);
  const Index next = triangle[(c + 1) % 3], previous = triangle[(c + 2) % 3];
  if (is_turned) return {-angles.normal, angles.angle[c], previous, next};
  return {angles.normal, angles.angle[c], next, previous};
}

bool has_repetition(std::vector<Index>& numbers) {
  constexpr std::size_t kFew = 12;
  if (numbers.size() > kFew) {
    ranges::sort(numbers.begin(), numbers.end());
    return std::adjacent_find(numbers.begin(), numbers.end()) != numbers.end();
  }
  bool repeated = false;
  for (std::size_t i = 1; i < numbers.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) repeated |= numbers[i] == numbers[j];
  }
  return repeated;
}

/// Whether two triangles traverse a common edge in the same direction: they have opposite winding,
/// or the edge has more than two triangles.
bool winding_conflicts(const std::vector<Corner>& corners) {
  thread_local std::vector<Index> ends;
  for (const auto end : {&Corner::next, &Corner::previous}) {
    ends.clear();
    for (const Corner& corner : corners) ends.push_back(corner.*end);
    if (has_repetition(ends)) return true;
  }
  return false;
}

/// The unit vector n with the largest sum of angle |<normal, n>| among the averages that result
/// from aligning all normals to one of them.
Vec3 unsigned_average(const std::vector<Corner>& corners) {
  Vec3 best = Vec3::Zero();
  float best_agreement = 0;
  // Bounds the work at vertices with thousands of triangles.
  const std::size_t references = std::min<std::size_t>(corners.size(), 64);
  for (std::size_t r = 0; r < references; ++r) {
    const Corner& reference = corners[r];
    Vec3 sum = Vec3::Zero();
    for (const Corner& corner : corners) {
      const float sign = corner.normal.dot(reference.normal) < 0 ? -1.0f : 1.0f;
      sum += sign * corner.angle * corner.normal;
    }
    const Vec3 candidate = unit(sum);
    float agreement = 0;
    for (const Corner& corner : corners) {
      agreement += corner.angle * std::abs(corner.normal.dot(candidate));
    }
    // Ties within rounding keep the first reference, for any order of additions.
    if (agreement > best_agreement * 1.0001f) {
      best = candidate;
      best_agreement = agreement;
    }
  }
  return best;
}

Vec3 mean_normal(const std::vector<Corner>& corners) {
  Vec3 sum = Vec3::Zero();
  for (const Corner& corner : corners) sum += corner.angle * corner.normal;
  return unit(sum);
}

}  // namespace

Vec3 triangle_normal(const Mesh& mesh, const Triangle& triangle) {
  const auto at = [&](int c) -> Eigen::Vector3d {
    return mesh.positions[triangle[c]].cast<double>();
  };
  const Eigen::Vector3d cross = doubled_area(at(0), at(1), at(2));
  const double area = cross.norm();
  if (!(area > 0)) return Vec3::Zero();
  return (cross / area).cast<float>();
}

std::vector<Vec3> vertex_normals(const Mesh& mesh) {
  return vertex_normals(mesh, vertex_triangles(mesh));
}

std::vector<Vec3> vertex_normals(const Mesh& mesh, const VertexTriangles& around,
                                 const Progress& progress) {
  std::vector<TriangleAngles> angles;
  std::vector<Vec3> normals;
  if (!fill_vertex_normals(mesh, around, {}, angles, normals, progress)) return normals;
  const std::vector<std::uint8_t> turned = triangles_to_turn(mesh, around);
  if (!turned.empty()) fill_vertex_normals(mesh, around, turned, angles, normals, progress);
  return normals;
}

bool fill_vertex_normals(const Mesh& mesh, const VertexTriangles& around,
                         std::span<const std::uint8_t> turned, std::vector<TriangleAngles>& angles,
                         std::vector<Vec3>& normals, const Progress& progress) {
  angles.resize(mesh.triangle_count());
  parallel_for(angles.size(), progress.part(0, 0.5), [&](std::size_t begin, std::size_t end) {
    for (std::size_t t = begin; t < end; ++t) angles[t] = angles_of(mesh, mesh.triangles[t]);
  });
  normals.resize(mesh.vertex_count());
  std::atomic<bool> any_conflict = false;
  parallel_for(mesh.vertex_count(), progress.part(0.5, 1), [&](std::size_t begin, std::size_t end) {
    thread_local std::vector<Corner> corners;
    for (auto v = static_cast<Index>(begin); v < end; ++v) {
      corners.clear();
      for (const Index t : around.of(v)) {
        const bool is_turned = !turned.empty() && turned[t] != 0;
        corners.push_back(corner_at(mesh.triangles[t], angles[t], v, is_turned));
      }
      const bool conflict = winding_conflicts(corners);
      if (conflict) any_conflict.store(true, std::memory_order_relaxed);
      normals[v] = conflict ? unsigned_average(corners) : mean_normal(corners);
    }
  });
  return any_conflict;
}

}  // namespace brindle
