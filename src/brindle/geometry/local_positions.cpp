#include "brindle/local_positions.h"

#include "brindle/base/text.h"

namespace brindle {
namespace {

constexpr double kMostDiagonals = 64;

}  // namespace

Eigen::Vector3d origin_near(std::span<const Eigen::Vector3d> positions,
                            std::span<const char> used) {
  Eigen::AlignedBox3d box;
  for (std::size_t v = 0; v < positions.size(); ++v) {
    const bool counts = used.empty() || used[v];
    // False for NaN.
    const bool usable = (positions[v].array().abs() <= kLargestCoordinate).all();
    if (counts && usable) box.extend(positions[v]);
  }
  return origin_near(box);
}

Eigen::Vector3d origin_near(const Eigen::AlignedBox3d& box) {
  if (box.isEmpty()) return Eigen::Vector3d::Zero();
  const double farthest = box.min().cwiseAbs().cwiseMax(box.max().cwiseAbs()).maxCoeff();
  const double diagonal = box.diagonal().norm();
  if (!(diagonal > 0) || farthest <= kMostDiagonals * diagonal) return Eigen::Vector3d::Zero();
  return box.center();
}

std::vector<Vec3> positions_about(const Eigen::Vector3d& origin,
                                  std::span<const Eigen::Vector3d> positions) {
  std::vector<Vec3> result;
  result.reserve(positions.size());
  for (const Eigen::Vector3d& position : positions) {
    result.emplace_back((position - origin).cast<float>());
  }
  return result;
}

std::string describe_origin(const Eigen::Vector3d& origin) {
  if (origin.isZero(0)) return "";
  return formatted(
      "coordinates are large against the size: recentred about %.12g %.12g %.12g; files are "
      "written "
      "where it was\n",
      origin.x(), origin.y(), origin.z());
}

}  // namespace brindle
