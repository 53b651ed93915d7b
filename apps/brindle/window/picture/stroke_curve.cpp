#include "window/picture/stroke_curve.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace brindle::tool {

Points catmull_rom(std::span<const Eigen::Vector3d> controls, int parts) {
  Points points;
  const std::size_t count = controls.size();
  for (std::size_t i = 0; i + 1 < count; ++i) {
    const Eigen::Vector3d& a = controls[i == 0 ? 0 : i - 1];
    const Eigen::Vector3d& b = controls[i];
    const Eigen::Vector3d& c = controls[i + 1];
    const Eigen::Vector3d& d = controls[std::min(i + 2, count - 1)];
    for (int part = 0; part < parts; ++part) {
      const double t = static_cast<double>(part) / parts;
      points.push_back(0.5 * (2 * b + t * (c - a) + t * t * (2 * a - 5 * b + 4 * c - d) +
                              t * t * t * (3 * b - a - 3 * c + d)));
    }
  }
  if (count > 0) points.push_back(controls.back());
  return points;
}

Points thinned(std::span<const Eigen::Vector3d> points, std::size_t most) {
  if (points.size() <= most) return {points.begin(), points.end()};
  Points result;
  for (std::size_t i = 0; i < most; ++i) {
    result.push_back(points[i * (points.size() - 1) / (most - 1)]);
  }
  return result;
}

bool leaves_surface(SeenPlace from, SeenPlace to, const PickPlace& pick) {
  constexpr int kHalvings = 6;
  constexpr double kStraight = 0.25, kJump = 0.25;  // of the distance between both
  const double distance = (to.place - from.place).norm();
  for (int i = 0; i < kHalvings; ++i) {
    const Eigen::Vector2d pixel = (from.pixel + to.pixel) / 2;
    const auto place = pick(pixel);
    if (!place) return true;
    const double to_middle = (*place - (from.place + to.place) / 2).norm();
    if (to_middle <= kStraight * (to.place - from.place).norm()) return false;
    const bool jumps_before = (*place - from.place).norm() > (*place - to.place).norm();
    (jumps_before ? to : from) = {pixel, *place};
  }
  // A surface that goes on is as near as the pixels are, at its rim as their roots.
  return (to.place - from.place).norm() > kJump * distance;
}

std::vector<Eigen::Vector2d> pixels_between(const Eigen::Vector2d& from, const Eigen::Vector2d& to,
                                            double step) {
  const int count = std::max(1, static_cast<int>(std::ceil((to - from).norm() / step)));
  std::vector<Eigen::Vector2d> pixels;
  for (int i = 1; i <= count; ++i) pixels.push_back(from + (to - from) * i / count);
  return pixels;
}

double distance_to_line(const Eigen::Vector2d& point, std::span<const Eigen::Vector2d> line) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i + 1 < line.size(); ++i) {
    const Eigen::Vector2d along = line[i + 1] - line[i];
    const double length = along.squaredNorm();
    const double share =
        length > 0 ? std::clamp((point - line[i]).dot(along) / length, 0.0, 1.0) : 0;
    least = std::min(least, (line[i] + share * along - point).norm());
  }
  return least;
}

}  // namespace brindle::tool
