#include <cmath>
#include <numeric>
#include <string>
#include <utility>

#include "brindle/base/parallel.h"
#include "brindle/error.h"
#include "brindle/local_positions.h"
#include "brindle/mesh.h"
#include "brindle/points.h"

namespace brindle {
namespace {

/// The used points that come first at their position, in ascending order. Sets `first` to that
/// point for every point.
std::vector<Index> first_at_their_place(const std::vector<Vec3>& positions,
                                        const std::vector<Index>& used, std::vector<Index>& first,
                                        const Progress& progress) {
  std::vector<Vec3> places;
  places.reserve(used.size());
  for (const Index i : used) places.push_back(positions[i]);
  const std::vector<Index> found = first_at_each_place(places, progress);
  first.resize(positions.size());
  std::iota(first.begin(), first.end(), Index{0});
  std::vector<Index> kept;
  for (Index k = 0; k < used.size(); ++k) {
    first[used[k]] = used[found[k]];
    if (found[k] == k) kept.push_back(used[k]);
  }
  return kept;
}

/// Normalises all normals; drops them if a used point has none.
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
  cloud.used = first_at_their_place(cloud.positions, cloud.used, loaded.first_at_place,
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
