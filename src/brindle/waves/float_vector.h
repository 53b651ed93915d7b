/// Directions from double precision to float.
#pragma once

#include <cmath>

#include <Eigen/Core>

#include "brindle/types.h"

namespace brindle {

/// A vector of floats in the same direction; extreme lengths are scaled.
inline Vec3 float_vector(const Eigen::Vector3d& vector) {
  const double size = vector.cwiseAbs().maxCoeff<Eigen::PropagateNaN>();
  const bool extreme = std::isfinite(size) && size > 0 && (size < 1e-18 || size > 1e18);
  return (extreme ? Eigen::Vector3d(vector / size) : vector).cast<float>();
}

}  // namespace brindle
