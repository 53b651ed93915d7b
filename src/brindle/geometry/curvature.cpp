#include <cmath>
#include <utility>

#include <Eigen/Dense>

#include "brindle/base/elementary.h"
#include "brindle/base/parallel.h"
#include "brindle/normals.h"

namespace brindle {
namespace {

/// Two unit vectors that span the plane orthogonal to `normal`.
std::pair<Eigen::Vector3d, Eigen::Vector3d> tangent_basis(const Eigen::Vector3d& normal) {
  int axis = 0;
  normal.cwiseAbs().minCoeff(&axis);
  const Eigen::Vector3d first = normal.cross(Eigen::Vector3d::Unit(axis)).normalized();
  return {first, normal.cross(first)};
}

/// The symmetric shape operator ((a, b), (b, c)) in a tangent basis: as (a, b, c), the
/// least-squares solution of S e = dn over the edges e, each scaled to unit length.
struct ShapeOperatorFit {
  Eigen::Matrix3d matrix = Eigen::Matrix3d::Zero();
  Eigen::Vector3d right = Eigen::Vector3d::Zero();
  double weight = 0;

  void add(const Eigen::Vector2d& e, const Eigen::Vector2d& dn) {
    const double w = 1 / e.squaredNorm();
    const double x = e[0], y = e[1];
    matrix +=
        w * Eigen::Matrix3d{{x * x, x * y, 0}, {x * y, x * x + y * y, x * y}, {0, x * y, y * y}};
    right += w * Eigen::Vector3d(x * dn[0], y * dn[0] + x * dn[1], y * dn[1]);
    weight += 1;
  }

  Eigen::Vector3d solve() const {
    // If all edges are collinear, the curvature across them is unknown: 0.
    return (matrix + 1e-9 * weight * Eigen::Matrix3d::Identity()).ldlt().solve(right);
  }
};

PrincipalCurvature principal(const Eigen::Vector3d& shape, const Eigen::Vector3d& first,
                             const Eigen::Vector3d& second) {
  const double mean = 0.5 * (shape[0] + shape[2]), half = 0.5 * (shape[0] - shape[2]);
  const double radius = std::hypot(half, shape[1]);
  const double angle = 0.5 * elementary::atan2(shape[1], half);
  // Along `angle` the curvature is mean + radius, across it mean - radius.
  const Eigen::Vector3d along = elementary::cos(angle) * first + elementary::sin(angle) * second;
  const Eigen::Vector3d across = elementary::cos(angle) * second - elementary::sin(angle) * first;
  PrincipalCurvature result{static_cast<float>(mean + radius), static_cast<float>(mean - radius),
                            along.cast<float>(), across.cast<float>()};
  if (std::abs(mean - radius) > std::abs(mean + radius)) {
    std::swap(result.maximum, result.minimum);
    std::swap(result.maximum_direction, result.minimum_direction);
  }
  return result;
}

PrincipalCurvature curvature_at(std::size_t v, std::span<const Vec3> positions,
                                std::span<const Vec3> normals, const Adjacency& neighborhood) {
  const Eigen::Vector3d normal = normals[v].cast<double>();
  if (normal.isZero()) return {};
  const auto [first, second] = tangent_basis(normal);
  const auto flat = [&, &b1 = first, &b2 = second](const Eigen::Vector3d& x) {
    return Eigen::Vector2d(x.dot(b1), x.dot(b2));
  };
  ShapeOperatorFit fit;
  for (const Index neighbor : neighborhood.of(static_cast<Index>(v))) {
    const Eigen::Vector3d other = normals[neighbor].cast<double>();
    const Eigen::Vector2d e =
        flat(positions[neighbor].cast<double>() - positions[v].cast<double>());
    if (other.isZero() || e.isZero(0)) continue;
    // Neighbours may have opposite winding.
    fit.add(e, flat(normal.dot(other) < 0 ? -other : other));
  }
  if (fit.weight == 0) return {};
  return principal(fit.solve(), first, second);
}

}  // namespace

std::vector<PrincipalCurvature> principal_curvatures(std::span<const Vec3> positions,
                                                     std::span<const Vec3> normals,
                                                     const Adjacency& neighborhood,
                                                     const Progress& progress) {
  JobStages stages(progress, {{"curvature", 1}});
  const Progress stage = stages.begin("curvature");
  std::vector<PrincipalCurvature> curvatures(positions.size());
  parallel_for(positions.size(), stage, [&](std::size_t begin, std::size_t end) {
    for (std::size_t v = begin; v < end; ++v) {
      curvatures[v] = curvature_at(v, positions, normals, neighborhood);
    }
  });
  stages.finish();
  return curvatures;
}

}  // namespace brindle
