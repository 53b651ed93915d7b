#include "brindle/waves/circulation.h"

#include <cmath>

namespace brindle {
namespace {

constexpr float kThinnest = 0.02f;  ///< area over the square of the longest edge

Lanes dot(const LaneVectors& a, const LaneVectors& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

LaneVectors cross(const LaneVectors& a, const LaneVectors& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// -1 for numbers below zero, otherwise 1.
Lanes sign_of(const Lanes& x) {
  Lanes sign;
  for (int l = 0; l < kTriangleLanes; ++l) sign[l] = x[l] < 0 ? -1.0f : 1.0f;
  return sign;
}

/// The length of a unit vector's projection into the plane, at least 0.1.
Lanes length_in_plane(const LaneVectors& direction, const LaneVectors& normal) {
  const Lanes out = dot(direction, normal);
  return square_root((1 - out * out).max(0.01f));
}

}  // namespace

Lanes divisor(const Lanes& x) {
  Lanes safe;
  for (int l = 0; l < kTriangleLanes; ++l) safe[l] = x[l] == 0 ? 1.0f : x[l];
  return safe;
}

Lanes square_root(const Lanes& x) {
  Lanes root;
  for (int l = 0; l < kTriangleLanes; ++l) root[l] = std::sqrt(x[l]);
  return root;
}

TriangleShapes triangle_shapes(const std::array<LaneVectors, 3>& corners) {
  TriangleShapes shapes;
  Lanes longest = Lanes::Zero();
  for (int m = 0; m < 3; ++m) {
    for (int k = 0; k < 3; ++k) {
      shapes.edge[m][k] = corners[(m + 2) % 3][k] - corners[(m + 1) % 3][k];
    }
    longest = longest.max(dot(shapes.edge[m], shapes.edge[m]));
  }
  shapes.normal = cross(shapes.edge[0], shapes.edge[1]);
  const Lanes twice = square_root(dot(shapes.normal, shapes.normal));
  for (Lanes& coordinate : shapes.normal) coordinate /= divisor(twice);
  shapes.area = (twice / 2).max(kThinnest * longest);
  const Lanes scale = -0.25f / divisor(shapes.area);
  for (int m = 0; m < 3; ++m) {
    shapes.half_cotangent[m] = scale * dot(shapes.edge[(m + 1) % 3], shapes.edge[(m + 2) % 3]);
  }
  return shapes;
}

std::array<Lanes, 3> circulation_coefficients(const TriangleShapes& shapes,
                                              const std::array<LaneVectors, 3>& directions) {
  const Lanes sign_1 = sign_of(dot(directions[0], directions[1]));
  const Lanes sign_2 = sign_of(dot(directions[0], directions[2]));
  const Lanes sign_12 = sign_of(dot(directions[1], directions[2]));
  const Lanes orientable = (1 + sign_1 * sign_2 * sign_12) / 2;
  const std::array<Lanes, 3> sign = {orientable, orientable * sign_1, orientable * sign_2};
  std::array<Lanes, 3> coefficients;
  for (int m = 0; m < 3; ++m) {
    // The two edges at a corner add up to the third one reversed.
    coefficients[m] = -0.5f * sign[m] * dot(shapes.edge[m], directions[m]) /
                      length_in_plane(directions[m], shapes.normal);
  }
  return coefficients;
}

}  // namespace brindle
