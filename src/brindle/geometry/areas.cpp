#include "brindle/geometry/measures.h"

#include <Eigen/Geometry>

namespace brindle {

float triangle_area(const Mesh& mesh, const Triangle& triangle) {
  const Vec3& a = mesh.positions[triangle[0]];
  return 0.5f * (mesh.positions[triangle[1]] - a).cross(mesh.positions[triangle[2]] - a).norm();
}

std::vector<float> vertex_areas(const Mesh& mesh) {
  std::vector<float> areas(mesh.vertex_count());
  for (const Triangle& triangle : mesh.triangles) {
    const float third = triangle_area(mesh, triangle) / 3;
    for (const Index vertex : triangle) areas[vertex] += third;
  }
  return areas;
}

}  // namespace brindle
