#include <algorithm>
#include <functional>
#include <numeric>
#include <string>
#include <tuple>
#include <utility>

#include "brindle/base/parallel.h"
#include "brindle/base/reported_sort.h"
#include "brindle/error.h"
#include "brindle/local_positions.h"
#include "brindle/mesh.h"
#include "brindle/points.h"

namespace brindle {
namespace {

/// The first of all points at one place, in ascending order. `first` tells of every point which
/// that is.
std::vector<Index> first_at_their_place(const std::vector<Vec3>& positions,
                                        std::vector<Index> points, std::vector<Index>& first,
                                        const Progress& progress) {
  const auto place = [&](Index i) {
    const Vec3& p = positions[i];
    return std::tuple(p.x(), p.y(), p.z());
  };
  reported_sort(points.begin(), points.end(), progress.part(0, 0.8), [&](Index i, Index j) {
    return std::tuple(place(i), i) < std::tuple(place(j), j);
  });
  progress.report(0.8);
  first.resize(positions.size());
  std::iota(first.begin(), first.end(), Index{0});
  reported_for(points.size(), progress.part(0.8, 0.87), [&](std::size_t i) {
    if (i == 0) return;
    if (place(points[i]) == place(points[i - 1])) first[points[i]] = first[points[i - 1]];
  });
  progress.report(0.87);
  points.erase(std::unique(points.begin(), points.end(),
                           [&](Index i, Index j) { return place(i) == place(j); }),
               points.end());
  progress.report(0.9);
  reported_sort(points.begin(), points.end(), progress.part(0.9, 1), std::less<>());
  return points;
}

/// Makes all normals unit vectors; none are left if one of a point in use has no direction.
void repair_normals(PointCloud& cloud, PointRepair& repair) {
  if (cloud.normals.empty()) return;
  for (Vec3& normal : cloud.normals) {
    const float length = normal.stableNorm();
    normal = length > 0 && std::isfinite(length) ? Vec3(normal / length) : Vec3(Vec3::Zero());
  }
  for (const Index i : cloud.used) repair.without_normal += cloud.normals[i].isZero(0);
  if (repair.without_normal > 0) cloud.normals.clear();
}

}  // namespace

LoadedPoints make_point_cloud(std::vector<Vec3> positions, std::vector<Vec3> normals,
                              const Progress& progress) {
  if (!normals.empty() && normals.size() != positions.size()) {
    throw Error("a point cloud must have as many normals as points, or none");
  }
  JobStages stages(progress, {{"points", 1}, {"places", 3}});
  stages.begin("points");
  LoadedPoints loaded;
  PointCloud& cloud = loaded.cloud;
  cloud.positions = std::move(positions);
  cloud.normals = std::move(normals);
  const std::vector<char> finite = set_positions_finite(cloud.positions);
  for (Index i = 0; i < cloud.positions.size(); ++i) {
    if (finite[i]) cloud.used.push_back(i);
  }
  loaded.repair.not_finite = cloud.positions.size() - cloud.used.size();
  const std::size_t count = cloud.used.size();
  cloud.used = first_at_their_place(cloud.positions, std::move(cloud.used), loaded.first_at_place,
                                    stages.begin("places"));
  loaded.repair.repeated = count - cloud.used.size();
  if (loaded.repair.repeated == 0) loaded.first_at_place.clear();
  repair_normals(cloud, loaded.repair);
  stages.finish();
  return loaded;
}

LoadedPoints make_placed_point_cloud(std::span<const Eigen::Vector3d> positions,
                                     std::vector<Vec3> normals, const Progress& progress) {
  const Eigen::Vector3d origin = origin_near(positions);
  LoadedPoints loaded =
      make_point_cloud(positions_about(origin, positions), std::move(normals), progress);
  loaded.cloud.origin = origin;
  return loaded;
}

std::string describe(const PointRepair& repair) {
  std::string text;
  const auto line = [&](std::size_t count, const char* what) {
    if (count > 0) text += std::to_string(count) + ' ' + what + '\n';
  };
  line(repair.not_finite, "points with coordinates that are not finite or beyond 1e18: set aside");
  line(repair.repeated, "points at the place of another: set aside");
  line(repair.without_normal, "points with a normal that is zero or not finite: all are estimated");
  return text;
}

}  // namespace brindle
