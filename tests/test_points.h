/// Small sets of points and lines for the tests of several rooms.
#pragma once

#include <cstddef>
#include <random>
#include <utility>
#include <vector>

#include "brindle/polylines.h"

namespace brindle::testing_support {

/// In the cube from -1 to 1; the same every time.
inline std::vector<Vec3> random_points(std::size_t count) {
  std::mt19937 random(4);
  std::uniform_real_distribution<float> number(-1, 1);
  std::vector<Vec3> points(count);
  for (Vec3& p : points) p = Vec3(number(random), number(random), number(random));
  return points;
}

/// One line, its normals along z.
inline Polylines line_of(std::vector<Vec3> points, bool closed) {
  Polylines lines;
  lines.points = std::move(points);
  lines.normals.assign(lines.points.size(), Vec3(0, 0, 1));
  lines.offsets.push_back(static_cast<Index>(lines.points.size()));
  lines.closed.push_back(closed);
  return lines;
}

}  // namespace brindle::testing_support
