#include "brindle/geometry/append_mesh.h"

#include "brindle/geometry/local_positions.h"

namespace brindle {

void append(const Mesh& other, Mesh& mesh) {
  const auto first = static_cast<Index>(mesh.positions.size());
  if (mesh.positions.empty()) mesh.origin = other.origin;
  mesh.positions.insert(mesh.positions.end(), other.positions.begin(), other.positions.end());
  if (other.origin != mesh.origin) {
    const Eigen::Vector3d way = other.origin - mesh.origin;
    for (std::size_t v = first; v < mesh.positions.size(); ++v) {
      mesh.positions[v] = placed(mesh.positions[v], way).cast<float>();
    }
  }
  mesh.triangles.reserve(mesh.triangles.size() + other.triangles.size());
  for (const Triangle& t : other.triangles) {
    mesh.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
  }
}

}  // namespace brindle
