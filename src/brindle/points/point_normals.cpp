#include "brindle/points/point_normals.h"

#include <algorithm>
#include <cmath>
#include <queue>
#include <tuple>

#include <Eigen/Eigenvalues>

#include "brindle/base/parallel.h"
#include "brindle/base/standard.h"

namespace brindle {
namespace {

/// Squared width-to-length ratios: below kThinnest points are collinear, below kThin the plane
/// depends on few of them.
constexpr double kThinnest = 1e-8;
constexpr double kThin = 0.1;

struct PlaneFit {
  Eigen::Vector3d normal;
  double width;      ///< squared width-to-length ratio
  double thickness;  ///< squared thickness-to-width ratio
};

/// The best-fitting plane of the point and `others`.
PlaneFit fitted_plane(Index point, std::span<const Vec3> positions, std::span<const Index> others) {
  // Relative to the point, which keeps digits far from the origin.
  const auto from_point = [&](Index j) -> Eigen::Vector3d {
    return positions[j].cast<double>() - positions[point].cast<double>();
  };
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  for (const Index j : others) mean += from_point(j);
  mean /= static_cast<double>(others.size() + 1);
  Eigen::Matrix3d covariance = mean * mean.transpose();
  for (const Index j : others) {
    const Eigen::Vector3d offset = from_point(j) - mean;
    covariance += offset * offset.transpose();
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(covariance);
  const Eigen::Vector3d& squares = solver.eigenvalues();
  return {solver.eigenvectors().col(0), squares[2] > 0 ? squares[1] / squares[2] : 0,
          squares[1] > 0 ? squares[0] / squares[1] : 0};
}

/// The neighbours and their neighbours.
std::vector<Index> wider_neighbors(Index point, const Adjacency& neighborhood) {
  std::vector<Index> wider(neighborhood.of(point).begin(), neighborhood.of(point).end());
  for (const Index j : neighborhood.of(point)) {
    wider.insert(wider.end(), neighborhood.of(j).begin(), neighborhood.of(j).end());
  }
  ranges::sort(wider.begin(), wider.end());
  wider.erase(std::unique(wider.begin(), wider.end()), wider.end());
  std::erase(wider, point);
  return wider;
}

Vec3 fitted_normal(Index point, std::span<const Vec3> positions, const Adjacency& neighborhood) {
  PlaneFit fit = fitted_plane(point, positions, neighborhood.of(point));
  if (fit.width < kThin) {
    fit = fitted_plane(point, positions, wider_neighbors(point, neighborhood));
  }
  return fit.width > kThinnest ? Vec3(fit.normal.cast<float>().normalized()) : Vec3(Vec3::Zero());
}

/// The axis closest to the normals of the point and its neighbours, up to sign. Otherwise a single
/// badly fitted plane could stand across the surface.
Vec3 mean_axis(Index point, std::span<const Vec3> normals, const Adjacency& neighborhood) {
  if (normals[point].isZero(0)) return Vec3::Zero();
  Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
  const auto add = [&](Index i) {
    const Eigen::Vector3d normal = normals[i].cast<double>();
    sum += normal * normal.transpose();
  };
  add(point);
  for (const Index neighbor : neighborhood.of(point)) add(neighbor);
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(sum);
  return solver.eigenvectors().col(2).cast<float>().normalized();
}

/// On a closed surface the mean of <n, p> is three volumes over area (divergence theorem), for any
/// origin. Components that enclose nothing get normals that point up.
bool points_inwards(std::span<const Index> component, std::span<const Vec3> positions,
                    std::span<const Vec3> normals) {
  Eigen::Vector3d middle = Eigen::Vector3d::Zero(), up = Eigen::Vector3d::Zero();
  for (const Index i : component) middle += positions[i].cast<double>();
  middle /= static_cast<double>(component.size());
  double outwards = 0, size = 0;
  for (const Index i : component) {
    const Eigen::Vector3d offset = positions[i].cast<double>() - middle;
    outwards += offset.dot(normals[i].cast<double>());
    size += offset.norm();
    up += normals[i].cast<double>();
  }
  constexpr double kFlat = 1e-3;
  return std::abs(outwards) > kFlat * size ? outwards < 0 : up.z() < 0;
}

/// An edge that may extend the spanning tree.
struct Candidate {
  float cost;
  Index from, to;

  bool operator<(const Candidate& other) const {  // reversed: the queue pops the largest
    return std::tie(cost, to, from) > std::tie(other.cost, other.to, other.from);
  }
};

}  // namespace

std::vector<Vec3> fitted_normals(std::span<const Vec3> positions, const Adjacency& neighborhood,
                                 const Progress& progress) {
  constexpr std::size_t kGrain = 256;
  std::vector<Vec3> fitted(positions.size()), normals(positions.size());
  const auto for_all_points = [&](const Progress& stage, const auto& work) {
    const auto work_on_range = [&](std::size_t begin, std::size_t end) {
      for (auto i = static_cast<Index>(begin); i < end; ++i) work(i);
    };
    parallel_for(positions.size(), stage, work_on_range, kGrain);
  };
  for_all_points(progress.part(0, 0.5),
                 [&](Index i) { fitted[i] = fitted_normal(i, positions, neighborhood); });
  for_all_points(progress.part(0.5, 1),
                 [&](Index i) { normals[i] = mean_axis(i, fitted, neighborhood); });
  return normals;
}

bool fill_volume(std::span<const Vec3> positions, std::span<const Index> used,
                 const Adjacency& neighborhood) {
  constexpr std::size_t kFewest = 50, kSamples = 1000;
  // In volumes the medians are 0.45 and 0.55, for random points and lattices. Noisy surfaces reach
  // kNear with few neighbours, thin tubes kWide with many, but not both.
  constexpr double kNear = 0.3, kWide = 0.4;
  if (used.size() < kFewest) return false;
  std::vector<double> near, wide;
  for (std::size_t k = 0; k < used.size(); k += 1 + used.size() / kSamples) {
    const Index point = used[k];
    near.push_back(fitted_plane(point, positions, neighborhood.of(point)).thickness);
    wide.push_back(fitted_plane(point, positions, wider_neighbors(point, neighborhood)).thickness);
  }
  const auto median = [](std::vector<double>& values) {
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
  };
  return median(near) > kNear && median(wide) > kWide;
}

void orient_normals(std::span<const Vec3> positions, const Adjacency& neighborhood,
                    std::span<Vec3> normals, const Progress& progress) {
  std::size_t visited = 0, taken = 0;
  std::vector<char> done(normals.size(), 0);
  std::vector<Index> component;
  std::priority_queue<Candidate> queue;
  const auto add = [&](Index point) {
    if (visited++ % kReportSlice == 0) {
      progress.report(static_cast<double>(visited) / static_cast<double>(normals.size()));
    }
    done[point] = 1;
    component.push_back(point);
    for (const Index neighbor : neighborhood.of(point)) {
      if (done[neighbor] || normals[neighbor].isZero(0)) continue;
      queue.push({1 - std::abs(normals[point].dot(normals[neighbor])), point, neighbor});
    }
  };
  for (Index start = 0; start < normals.size(); ++start) {
    if (done[start] || normals[start].isZero(0)) continue;
    component.clear();
    add(start);
    while (!queue.empty()) {
      if (++taken % kReportSlice == 0) {
        progress.report(static_cast<double>(visited) / static_cast<double>(normals.size()));
      }
      const Candidate next = queue.top();
      queue.pop();
      if (done[next.to]) continue;
      if (normals[next.from].dot(normals[next.to]) < 0) normals[next.to] = -normals[next.to];
      add(next.to);
    }
    if (points_inwards(component, positions, normals)) {
      for (const Index point : component) normals[point] = -normals[point];
    }
  }
}

}  // namespace brindle
