#include "brindle/mesh.h"

namespace brindle {
namespace {

BoundingBox box_around(const std::vector<Vec3>& positions) {
  if (positions.empty()) return {};
  BoundingBox box{positions[0], positions[0]};
  for (const Vec3& position : positions) {
    box.lower = box.lower.cwiseMin(position);
    box.upper = box.upper.cwiseMax(position);
  }
  return box;
}

}  // namespace

BoundingBox bounding_box(const Mesh& mesh) {
  if (mesh.triangles.empty()) return box_around(mesh.positions);
  BoundingBox box;
  box.lower = box.upper = mesh.positions[mesh.triangles[0][0]];
  for (const Triangle& triangle : mesh.triangles) {
    for (const Index vertex : triangle) {
      box.lower = box.lower.cwiseMin(mesh.positions[vertex]);
      box.upper = box.upper.cwiseMax(mesh.positions[vertex]);
    }
  }
  return box;
}

}  // namespace brindle
