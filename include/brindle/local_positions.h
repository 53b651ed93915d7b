/// Coordinates of files, which are doubles, as floats near an origin.
#pragma once

#include <span>
#include <string>
#include <vector>

#include <Eigen/Geometry>

#include "brindle/export.h"
#include "brindle/types.h"

namespace BRINDLE_EXPORT brindle {

/// Coordinates beyond count as none: squares of greater lengths leave the range of float.
inline constexpr double kLargestCoordinate = 1e18;

/// Where positions are to be measured from so that floats keep their shape: the centre of the box
/// around them if a coordinate exceeds 64 of the box's diagonals, otherwise zero. Up to there
/// floats tell points apart that are a 260,000th of the diagonal from each other. Positions whose
/// entry in `used` is 0 make no difference (none are left out if it is empty), nor do those that
/// are not finite or beyond `kLargestCoordinate`.
Eigen::Vector3d origin_near(std::span<const Eigen::Vector3d> positions,
                            std::span<const char> used = {});

/// The same for positions in that box.
Eigen::Vector3d origin_near(const Eigen::AlignedBox3d& box);

/// The positions relative to `origin`.
std::vector<Vec3> positions_about(const Eigen::Vector3d& origin,
                                  std::span<const Eigen::Vector3d> positions);

/// Where a position relative to `origin` stands.
inline Eigen::Vector3d placed(const Vec3& position, const Eigen::Vector3d& origin) {
  return position.cast<double>() + origin;
}

/// A line that tells a user of an origin; empty if it is zero.
std::string describe_origin(const Eigen::Vector3d& origin);

}  // namespace brindle
