#include "brindle/base/axis_mean.h"

#include <Eigen/Eigenvalues>

#include "brindle/base/standard.h"

namespace brindle {
namespace {

using Eigen::Vector3d;

Vector3d common_side(std::span<const WeightedAxis> axes) {
  Eigen::Matrix3d tensor = Eigen::Matrix3d::Zero();
  for (const auto& [axis, weight] : axes) {
    tensor += weight * axis * axis.stableNormalized().transpose();
  }
  return Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(tensor).eigenvectors().col(2);
}

/// Whether no product of two axes is negative, so that no axis has to be turned.
bool are_near(std::span<const WeightedAxis> axes) {
  return ranges::all_of(axes, [&](const WeightedAxis& a) {
    return ranges::all_of(axes, [&](const WeightedAxis& b) { return a.axis.dot(b.axis) >= 0; });
  });
}

}  // namespace

std::optional<Vector3d> mean_of_turned(std::span<const WeightedAxis> axes) {
  if (axes.size() < 2 || are_near(axes)) return std::nullopt;
  const Vector3d side = common_side(axes), first = axes.front().axis;
  const auto sign_of = [&](const Vector3d& axis) { return axis.dot(side) < 0 ? -1 : 1; };
  double weights = 0;
  bool any_turned = false;
  for (const auto& [axis, weight] : axes) {
    weights += weight;
    any_turned = any_turned || sign_of(axis) != sign_of(first);
  }
  if (!any_turned) return std::nullopt;
  // Relative to the first axis, so that the mean of equal axes is exact.
  Vector3d difference = Vector3d::Zero();
  for (const auto& [axis, weight] : axes) {
    difference += weight / weights * (sign_of(axis) * sign_of(first) * axis - first);
  }
  return first + difference;
}

}  // namespace brindle
