#include "brindle/files/mesh_builder.h"

#include <utility>

#include "brindle/geometry/local_positions.h"
#include "brindle/geometry/polygon.h"

namespace brindle {

void MeshBuilder::add_polygon(std::span<const Index> corners) {
  polygons_.push_back(static_cast<Index>(corners.size()));
  polygons_.insert(polygons_.end(), corners.begin(), corners.end());
}

template <class Use>
void MeshBuilder::for_each_polygon(const Use& use) const {
  for (std::size_t at = 0; at < polygons_.size(); at += 1 + polygons_[at]) {
    use(std::span(polygons_).subspan(at + 1, polygons_[at]));
  }
}

Mesh MeshBuilder::take() {
  std::vector<char> used(polygons_.empty() ? 0 : positions_.size(), 0);
  for_each_polygon([&](std::span<const Index> corners) {
    for (const Index corner : corners) used[corner] = 1;
  });
  Mesh mesh;
  mesh.origin = origin_near(positions_, used);
  mesh.positions = positions_about(mesh.origin, std::exchange(positions_, {}));
  for_each_polygon([&](std::span<const Index> corners) {
    triangulate_polygon(mesh.positions, corners, mesh.triangles);
  });
  polygons_ = {};
  return mesh;
}

}  // namespace brindle
