/// Coordinates of files, which are doubles, as floats relative to an origin.
#pragma once

#include <span>
#include <string>
#include <vector>

#include <Eigen/Geometry>

#include "brindle/export.h"
#include "brindle/types.h"

namespace BRINDLE_EXPORT brindle {

/// Larger coordinates are invalid: squares of greater lengths leave the range of float.
inline constexpr double kLargestCoordinate = 1e18;

/// The origin from which positions are measured so that floats keep their shape: the centre of the
/// bounding box if a coordinate exceeds 64 of its diagonals, otherwise zero. Up to there floats
/// resolve a 260,000th of the diagonal. Ignores positions whose entry in `used` is 0 (empty: all
/// are used), and those that are not finite or beyond `kLargestCoordinate`.
Eigen::Vector3d origin_near(std::span<const Eigen::Vector3d> positions,
                            std::span<const char> used = {});

/// As above for positions in that box.
Eigen::Vector3d origin_near(const Eigen::AlignedBox3d& box);

/// The positions relative to `origin`.
std::vector<Vec3> positions_about(const Eigen::Vector3d& origin,
                                  std::span<const Eigen::Vector3d> positions);

/// The absolute position of a point relative to `origin`.
inline Eigen::Vector3d placed(const Vec3& position, const Eigen::Vector3d& origin) {
  return position.cast<double>() + origin;
}

/// A line for the user about an origin; empty if it is zero.
std::string describe_origin(const Eigen::Vector3d& origin);

}  // namespace brindle
