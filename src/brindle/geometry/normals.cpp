#include "brindle/geometry/normals.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

#include "brindle/base/parallel.h"
#include "brindle/geometry/vertex_triangles.h"

namespace brindle {
namespace {

/// What one adjacent triangle tells about a vertex.
struct Corner {
  Vec3 normal;
  float angle;  ///< radians, at the vertex
  Index next;   ///< the other corners, in the triangle's winding
  Index previous;
};

/// Zero for the zero vector, where Eigen's `normalized` may lose tiny ones too.
Vec3 unit(const Vec3& v) {
  const double length = v.cast<double>().norm();
  return length > 0 ? (v.cast<double>() / length).cast<float>().eval() : Vec3::Zero();
}

Corner corner_at(const Mesh& mesh, const Triangle& triangle, std::size_t vertex) {
  const int c = triangle[0] == vertex ? 0 : triangle[1] == vertex ? 1 : 2;
  const Index next = triangle[(c + 1) % 3];
  const Index previous = triangle[(c + 2) % 3];
  const Eigen::Vector3d p = mesh.positions[vertex].cast<double>();
  const Eigen::Vector3d a = mesh.positions[next].cast<double>() - p;
  const Eigen::Vector3d b = mesh.positions[previous].cast<double>() - p;
  const Eigen::Vector3d cross = a.cross(b);
  const double area = cross.norm();
  if (!(area > 0)) return {Vec3::Zero(), 0, next, previous};
  const Eigen::Vector3d normal = cross / area;
  return {normal.cast<float>(), static_cast<float>(std::atan2(area, a.dot(b))), next, previous};
}

/// Whether two triangles run the same way along a common edge: they are wound against each other,
/// or the edge has more than two triangles.
bool winding_conflicts(const std::vector<Corner>& corners) {
  thread_local std::vector<Index> ends;
  for (const auto end : {&Corner::next, &Corner::previous}) {
    ends.clear();
    for (const Corner& corner : corners) ends.push_back(corner.*end);
    std::sort(ends.begin(), ends.end());
    if (std::adjacent_find(ends.begin(), ends.end()) != ends.end()) return true;
  }
  return false;
}

/// The unit vector n with the largest sum of angle |<normal, n>| among the averages that result
/// from aligning all normals to one of them.
Vec3 unsigned_average(const std::vector<Corner>& corners) {
  Vec3 best = Vec3::Zero();
  float best_agreement = 0;
  // A bound on the work at vertices with thousands of triangles.
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
    // Equal up to rounding: the first reference stays, whatever the order of the additions.
    if (agreement > best_agreement * 1.0001f) {
      best = candidate;
      best_agreement = agreement;
    }
  }
  return best;
}

Vec3 normal_of(const std::vector<Corner>& corners) {
  if (winding_conflicts(corners)) return unsigned_average(corners);
  Vec3 sum = Vec3::Zero();
  for (const Corner& corner : corners) sum += corner.angle * corner.normal;
  return unit(sum);
}

}  // namespace

Vec3 triangle_normal(const Mesh& mesh, const Triangle& triangle) {
  return corner_at(mesh, triangle, triangle[0]).normal;
}

std::vector<Vec3> vertex_normals(const Mesh& mesh) {
  const VertexTriangles around = vertex_triangles(mesh);
  std::vector<Vec3> normals(mesh.vertex_count());
  parallel_for(mesh.vertex_count(), [&](std::size_t begin, std::size_t end) {
    std::vector<Corner> corners;
    for (std::size_t v = begin; v < end; ++v) {
      corners.clear();
      for (const Index t : around.of(v)) corners.push_back(corner_at(mesh, mesh.triangles[t], v));
      normals[v] = normal_of(corners);
    }
  });
  return normals;
}

}  // namespace brindle
