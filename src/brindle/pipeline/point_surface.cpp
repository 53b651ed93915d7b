#include "brindle/pipeline/point_surface.h"

#include <algorithm>
#include <utility>

#include "brindle/base/error.h"
#include "brindle/surface/point_neighborhood.h"
#include "brindle/surface/point_normals.h"

namespace brindle {
namespace {

/// The normals of all points, zero for those that are not used.
std::vector<Vec3> normals_of(PointCloud& cloud, const Adjacency& neighborhood) {
  if (cloud.normals.empty()) {
    std::vector<Vec3> normals = fitted_normals(cloud.positions, neighborhood);
    orient_normals(cloud.positions, neighborhood, normals);
    return normals;
  }
  std::vector<Vec3> normals(cloud.positions.size(), Vec3::Zero());
  for (const Index i : cloud.used) normals[i] = cloud.normals[i];
  return normals;
}

}  // namespace

Surface make_point_surface(PointCloud cloud, int neighbors) {
  Surface surface;
  surface.neighborhood =
      std::make_shared<const Adjacency>(point_neighborhood(cloud.positions, cloud.used, neighbors));
  surface.normals = normals_of(cloud, *surface.neighborhood);
  if (std::ranges::all_of(surface.normals, [](const Vec3& n) { return n.isZero(0); })) {
    throw Error(
        "the points make no surface: there are fewer than three, or they lie on a line; give more "
        "points, or points with normals");
  }
  surface.mesh.positions = std::move(cloud.positions);
  surface.mesh.origin = cloud.origin;
  return surface;
}

}  // namespace brindle
