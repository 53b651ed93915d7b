/// Vessel trees that fill a body.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include <Eigen/Core>

#include "brindle/shapes/capsules.h"

namespace brindle {

struct VascularTree {
  Eigen::Vector3d root, direction;  ///< start of the trunk, and its unit direction
  double trunk = 0;                 ///< length before the first branch
  double radius = 0;                ///< of the trunk
  double step = 0;                  ///< segment length
  double thinnest = 0;              ///< smallest radius of a vessel
};

/// Grows vessels towards points until all are near (space colonization, Runions et al. 2007),
/// within about three steps. At forks, radius^3 is the sum over the branches (Murray's law),
/// subject to `thinnest`.
std::vector<Capsule> grow_vessels(const VascularTree& tree,
                                  const std::vector<Eigen::Vector3d>& places);

/// About `count` points of a box that `inside` accepts, more evenly spread than random ones.
std::vector<Eigen::Vector3d> scattered_places(
    const Eigen::Vector3d& lower, const Eigen::Vector3d& upper, int count, std::uint32_t seed,
    const std::function<bool(const Eigen::Vector3d&)>& inside);

}  // namespace brindle
