#include "brindle/geometry/rounded_midpoints.h"

#include <algorithm>
#include <cmath>

namespace brindle {

RoundedMidpoints::RoundedMidpoints(const Mesh& mesh, const Progress& progress)
    : mesh_(mesh),
      around_(vertex_triangles(mesh, progress.part(0, 0.4))),
      angles_(mesh.triangle_count()) {
  std::vector<Vec3> normals(mesh.vertex_count());
  fill_vertex_normals(mesh, around_, angles_, normals, progress.part(0.4, 1));
}

/// Zero where the surface has an edge or none to speak of.
Vec3 RoundedMidpoints::normal_of_edge(Index a, Index b) const {
  Vec3 sum = Vec3::Zero(), first = Vec3::Zero();
  bool first_runs_on = false;
  int count = 0;
  for (const Index t : around_.of(a)) {
    const Triangle& triangle = mesh_.triangles[t];
    const int c = corner_of(triangle, a);
    const bool runs_on = triangle[(c + 1) % 3] == b;
    if (!runs_on && triangle[(c + 2) % 3] != b) continue;
    // Triangles that are wound alike run along their edge in opposite ways.
    const bool against = count == 1 && runs_on == first_runs_on;
    const Vec3 normal = against ? Vec3(-angles_[t].normal) : angles_[t].normal;
    if (++count == 1) {
      first = normal;
      first_runs_on = runs_on;
    } else if (count > 2 || normal.dot(first) < kCosineOfCrease) {
      return Vec3::Zero();
    }
    sum += normal;
  }
  return sum.normalized();
}

Vec3 RoundedMidpoints::normal_at(Index vertex, const Vec3& of_edge) const {
  Vec3 sum = Vec3::Zero();
  for (const Index t : around_.of(vertex)) {
    const TriangleAngles& angles = angles_[t];
    const float alike = angles.normal.dot(of_edge);
    if (std::abs(alike) < kCosineOfCrease) continue;
    const float angle = angles.angle[corner_of(mesh_.triangles[t], vertex)];
    sum += (alike < 0 ? -angle : angle) * angles.normal;
  }
  return sum.normalized();
}

Vec3 RoundedMidpoints::shift(Index a, Index b) const {
  if (a > b) std::swap(a, b);
  const Vec3 of_edge = normal_of_edge(a, b);
  if (of_edge.isZero(0)) return Vec3::Zero();
  const Vec3 way = mesh_.positions[b] - mesh_.positions[a];
  const Vec3 normal_a = normal_at(a, of_edge), normal_b = normal_at(b, of_edge);
  const Vec3 shift = (way.dot(normal_b) * normal_b - way.dot(normal_a) * normal_a) / 8;
  return shift.allFinite() ? shift : Vec3(Vec3::Zero());
}

}  // namespace brindle
