/// Trees of vessels that fill a body.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include <Eigen/Core>

#include "brindle/shapes/capsules.h"

namespace brindle {

struct VascularTree {
  Eigen::Vector3d root, direction;  ///< where the trunk begins, and where it goes (unit)
  double trunk = 0;                 ///< length before it may branch
  double radius = 0;                ///< of the trunk
  double step = 0;                  ///< length of a piece
  double thinnest = 0;              ///< smallest radius that a vessel may have
};

/// Vessels that grow towards places until they are near to all of them (space colonisation, Runions
/// and others 2007). Where vessels meet, radius^3 is the sum of those of the branches (Murray's
/// law), but for what `thinnest` asks for. The places are reached up to about three steps.
std::vector<Capsule> grow_vessels(const VascularTree& tree,
                                  const std::vector<Eigen::Vector3d>& places);

/// About `count` places inside of a box that `inside` accepts, more evenly spread than at random.
std::vector<Eigen::Vector3d> scattered_places(
    const Eigen::Vector3d& lower, const Eigen::Vector3d& upper, int count, std::uint32_t seed,
    const std::function<bool(const Eigen::Vector3d&)>& inside);

}  // namespace brindle
