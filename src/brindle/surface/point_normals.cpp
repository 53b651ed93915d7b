#include "brindle/surface/point_normals.h"

#include <algorithm>
#include <cmath>
#include <queue>
#include <tuple>

#include <Eigen/Eigenvalues>

#include "brindle/base/parallel.h"

namespace brindle {
namespace {

/// Square of the width over the length below which points lie on a line.
constexpr double kThinnest = 1e-8;

Vec3 fitted_normal(Index point, std::span<const Vec3> positions, std::span<const Index> neighbors) {
  // Relative to the point: far from the origin nothing else has digits to lose.
  const auto from_point = [&](Index j) -> Eigen::Vector3d {
    return positions[j].cast<double>() - positions[point].cast<double>();
  };
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  for (const Index j : neighbors) mean += from_point(j);
  mean /= static_cast<double>(neighbors.size() + 1);
  Eigen::Matrix3d covariance = mean * mean.transpose();
  for (const Index j : neighbors) {
    const Eigen::Vector3d offset = from_point(j) - mean;
    covariance += offset * offset.transpose();
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(covariance);
  const Eigen::Vector3d& squares = solver.eigenvalues();
  if (!(squares[1] > kThinnest * squares[2])) return Vec3::Zero();
  return solver.eigenvectors().col(0).cast<float>().normalized();
}

/// Around a closed surface the mean of <n, p> is three volumes over the area (divergence theorem),
/// wherever the origin is. Where nothing is enclosed, normals shall point up.
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

/// An edge that leads out of the tree.
struct Candidate {
  float cost;
  Index from, to;

  bool operator<(const Candidate& other) const {  // the last in the queue's order is the first out
    return std::tie(cost, to, from) > std::tie(other.cost, other.to, other.from);
  }
};

}  // namespace

std::vector<Vec3> fitted_normals(std::span<const Vec3> positions, const Adjacency& neighborhood) {
  std::vector<Vec3> normals(positions.size());
  parallel_for(
      normals.size(),
      [&](std::size_t begin, std::size_t end) {
        for (auto i = static_cast<Index>(begin); i < end; ++i) {
          normals[i] = fitted_normal(i, positions, neighborhood.of(i));
        }
      },
      256);
  return normals;
}

void orient_normals(std::span<const Vec3> positions, const Adjacency& neighborhood,
                    std::span<Vec3> normals) {
  std::vector<char> done(normals.size(), 0);
  std::vector<Index> component;
  std::priority_queue<Candidate> queue;
  const auto add = [&](Index point) {
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
