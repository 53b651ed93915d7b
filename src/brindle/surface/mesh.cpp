#include "brindle/surface/mesh.h"

namespace brindle {

BoundingBox bounding_box(const Mesh& mesh) {
  if (mesh.triangles.empty()) return {};
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
