/// The mean of axes: directions without sign.
#pragma once

#include <cmath>
#include <optional>
#include <span>

#include <Eigen/Core>

#include "brindle/types.h"

namespace brindle {

struct WeightedAxis {
  Eigen::Vector3d axis;
  double weight;  ///< above 0
};

/// The weighted mean of vectors as axes (v equals -v): the vector mean after turning all to the
/// side of the first one. The eigenvector with the largest eigenvalue of sum w d d^T / |d|
/// separates the sides. Nullopt if no vector has to be turned: the vector mean is the result. Not
/// finite if a vector is not.
std::optional<Eigen::Vector3d> mean_of_turned(std::span<const WeightedAxis> axes);

// Directions from double precision to float.

/// A vector of floats in the same direction; extreme lengths are scaled.
inline Vec3 float_vector(const Eigen::Vector3d& vector) {
  const double size = vector.cwiseAbs().maxCoeff<Eigen::PropagateNaN>();
  const bool extreme = std::isfinite(size) && size > 0 && (size < 1e-18 || size > 1e18);
  return (extreme ? Eigen::Vector3d(vector / size) : vector).cast<float>();
}

}  // namespace brindle
