#include <algorithm>
#include <string>
#include <utility>

#include "brindle/base/standard.h"
#include "brindle/error.h"
#include "brindle/geometry/measures.h"
#include "brindle/points.h"
#include "brindle/points/point_normals.h"

namespace brindle {
namespace {

/// The normals of all points; zero for unused ones.
std::vector<Vec3> normals_of(PointCloud& cloud, const Adjacency& neighborhood,
                             const Progress& progress) {
  if (cloud.normals.empty()) {
    if (fill_volume(cloud.positions, cloud.used, neighborhood)) {
      throw Error(
          "the points fill a volume, and stripes lie on surfaces: take the points of a surface, or "
          "give points with normals");
    }
    std::vector<Vec3> normals =
        fitted_normals(cloud.positions, neighborhood, progress.part(0, 0.6));
    orient_normals(cloud.positions, neighborhood, normals, progress.part(0.6, 1));
    return normals;
  }
  std::vector<Vec3> normals(cloud.positions.size(), Vec3::Zero());
  for (const Index i : cloud.used) normals[i] = cloud.normals[i];
  return normals;
}

/// Checks what `make_point_cloud` guarantees.
void check(const PointCloud& cloud) {
  const std::size_t points = cloud.positions.size();
  if (!cloud.normals.empty() && cloud.normals.size() != points) {
    throw Error("a point cloud must have as many normals as points, or none");
  }
  for (std::size_t k = 0; k < cloud.used.size(); ++k) {
    const Index i = cloud.used[k];
    if (i >= points || (k > 0 && cloud.used[k - 1] >= i)) {
      throw Error("point cloud: entry " + std::to_string(k) + " of the points in use, " +
                  std::to_string(i) + ", is out of range or not above the one before; there are " +
                  std::to_string(points) + " points");
    }
    if (!cloud.normals.empty() && !cloud.normals[i].allFinite()) {
      throw Error("point cloud: the normal of point " + std::to_string(i) +
                  " is not finite; give it one, or leave out all to have them estimated");
    }
  }
}

}  // namespace

Surface make_point_surface(PointCloud cloud, int neighbors, const Progress& progress) {
  check_positions(cloud.positions);
  check(cloud);
  JobStages stages(progress, {{"neighborhood", 3}, {"normals", 3}});
  Surface surface;
  surface.neighborhood = std::make_shared<const Adjacency>(
      point_neighborhood(cloud.positions, cloud.used, neighbors, stages.begin("neighborhood")));
  check_edge_lengths(edge_lengths(cloud.positions, *surface.neighborhood));
  surface.normals = normals_of(cloud, *surface.neighborhood, stages.begin("normals"));
  if (ranges::all_of(surface.normals, [](const Vec3& n) { return n.isZero(0); })) {
    throw Error(
        "the points make no surface: there are fewer than three, or they lie on a line; give more "
        "points, or points with normals");
  }
  surface.mesh.positions = std::move(cloud.positions);
  surface.mesh.origin = cloud.origin;
  stages.finish();
  return surface;
}

}  // namespace brindle
