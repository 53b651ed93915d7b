#include "brindle/points.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

#include "brindle/base/compressed_rows.h"
#include "brindle/base/memory.h"
#include "brindle/base/parallel.h"
#include "brindle/base/standard.h"
#include "brindle/error.h"
#include "brindle/geometry/measures.h"
#include "brindle/local_positions.h"
#include "brindle/mesh.h"
#include "brindle/points/point_normals.h"
#include "brindle/points/point_tree.h"

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

namespace {

/// The `count` nearest other points of each used point.
std::vector<Index> nearest_others(std::span<const Vec3> positions, std::span<const Index> used,
                                  std::size_t count, const Progress& progress) {
  std::vector<Vec3> points;
  points.reserve(used.size());
  for (const Index i : used) points.push_back(positions[i]);
  const PointTree tree(points, progress.part(0, 0.2));
  std::vector<Index> nearest(used.size() * count);
  const auto find = [&](std::size_t begin, std::size_t end) {
    std::vector<Index> found;
    for (std::size_t i = begin; i < end; ++i) {
      // The result includes the point itself.
      tree.nearest(points[i], count + 1, found);
      std::size_t taken = 0;
      for (const Index other : found) {
        if (other != i && taken < count) nearest[i * count + taken++] = used[other];
      }
    }
  };
  constexpr std::size_t kGrain = 256;
  parallel_for(used.size(), progress.part(0.2, 1), find, kGrain);
  return nearest;
}

/// Symmetric rows: i's nearest points and those that i is nearest to. Unsorted, with duplicates.
CompressedRows<Index> joined_both_ways(std::span<const Index> used, std::span<const Index> nearest,
                                       std::size_t count, std::size_t points,
                                       const Progress& progress) {
  const auto add_all = [&](const Progress& part, const auto& add) {
    reported_for(nearest.size(), part, [&](std::size_t k) {
      const Index i = used[k / count], j = nearest[k];
      add(i, j);
      add(j, i);
    });
  };
  return compressed_rows<Index>(points, progress, add_all);
}

/// Sorts every row and removes duplicates.
Adjacency tidied(CompressedRows<Index> rows, const Progress& progress) {
  Adjacency result;
  result.offsets.assign(rows.size() + 1, 0);
  result.neighbors.reserve(rows.entries.size());
  reported_for(rows.size(), progress, [&](std::size_t i) {
    const std::span<Index> row = rows.of(i);
    ranges::sort(row);
    result.neighbors.insert(result.neighbors.end(), row.begin(),
                            std::unique(row.begin(), row.end()));
    result.offsets[i + 1] = static_cast<Index>(result.neighbors.size());
  });
  return result;
}

/// Throws TooLarge if memory cannot hold the neighbours found and the symmetric rows with and
/// without duplicates.
void check_room(std::size_t points, std::size_t others) {
  constexpr double kBytes = 5 * sizeof(Index);
  const auto count = static_cast<double>(points);
  check_fits(
      count * static_cast<double>(others), kBytes,
      std::to_string(others) + " neighbours of each of " + std::to_string(points) + " points",
      "neighbours", [&](double most) {
        return most < count ? std::string("take fewer points")
                            : rounded_down(std::floor(most / count)) + " each would do";
      });
}

}  // namespace

Adjacency point_neighborhood(std::span<const Vec3> positions, std::span<const Index> used,
                             int count, const Progress& progress) {
  if (count < 1) throw Error("points need at least one neighbour each");
  if (used.size() < 2) return {std::vector<Index>(positions.size() + 1, 0), {}};
  const std::size_t others = std::min(static_cast<std::size_t>(count), used.size() - 1);
  if (used.size() > 0xfffffffe / (2 * others)) {
    throw Error("there are too many points for this number of neighbours; take fewer of either");
  }
  check_room(used.size(), others);
  const std::vector<Index> nearest = nearest_others(positions, used, others, progress.part(0, 0.7));
  progress.report(0.7);
  CompressedRows<Index> rows =
      joined_both_ways(used, nearest, others, positions.size(), progress.part(0.7, 0.85));
  return tidied(std::move(rows), progress.part(0.85, 1));
}

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
