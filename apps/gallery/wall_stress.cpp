#include "gallery/wall_stress.h"

#include <algorithm>

namespace brindle {

MembraneStress membrane_stress(double pressure, double thickness, double k1, double k2,
                               double least_curvature) {
  const double around = std::max(k1, least_curvature);
  const double second = pressure / (2 * thickness * around);
  return {second * (2 - k2 / around), second};
}

std::array<float, 6> stress_tensor(const MembraneStress& stress, const LevelCurvature& curvature) {
  const Eigen::Matrix3d tensor =
      stress.first * curvature.larger_direction * curvature.larger_direction.transpose() +
      stress.second * curvature.smaller_direction * curvature.smaller_direction.transpose();
  const Eigen::Matrix3f t = tensor.cast<float>();
  return {t(0, 0), t(1, 1), t(2, 2), t(0, 1), t(1, 2), t(0, 2)};
}

}  // namespace brindle
