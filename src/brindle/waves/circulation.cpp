#include "brindle/waves/circulation.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "brindle/base/elementary.h"
#include "brindle/base/parallel.h"
#include "brindle/base/standard.h"

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

namespace {

/// The corners of the triangles from `first` on, one per lane; the mesh's last one fills up lanes.
template <class At>
std::array<LaneVectors, 3> corners_of(const Mesh& mesh, std::size_t first, const At& at) {
  std::array<LaneVectors, 3> corners;
  for (int lane = 0; lane < kTriangleLanes; ++lane) {
    const std::size_t last = mesh.triangles.size() - 1;
    const Triangle& triangle =
        mesh.triangles[std::min(first + static_cast<std::size_t>(lane), last)];
    for (std::size_t m = 0; m < 3; ++m) {
      const Vec3 value = at(triangle[m]);
      for (std::size_t k = 0; k < 3; ++k) corners[m][k][lane] = value[static_cast<int>(k)];
    }
  }
  return corners;
}

}  // namespace

CurlSums curl_sums(const Mesh& mesh, std::span<const Vec3> directions,
                   std::span<const Vec3> normals) {
  const std::size_t count = mesh.triangles.size();
  const std::size_t groups = (count + kTriangleLanes - 1) / kTriangleLanes;
  return parallel_sum<CurlSums>(groups, [&](std::size_t begin, std::size_t end) {
    CurlSums sums;
    for (std::size_t group = begin; group < end; ++group) {
      const std::size_t first = group * kTriangleLanes;
      const TriangleShapes shapes =
          triangle_shapes(corners_of(mesh, first, [&](Index v) { return mesh.positions[v]; }));
      const auto along = circulation_coefficients(
          shapes, corners_of(mesh, first, [&](Index v) { return directions[v]; }));
      const auto across = circulation_coefficients(
          shapes, corners_of(mesh, first,
                             [&](Index v) -> Vec3 { return normals[v].cross(directions[v]); }));
      const Lanes area = divisor(shapes.area);
      for (int lane = 0; lane < kTriangleLanes && first + static_cast<std::size_t>(lane) < count;
           ++lane) {
        const double curl = along[0][lane] + along[1][lane] + along[2][lane];
        const double divergence = across[0][lane] + across[1][lane] + across[2][lane];
        sums.curl += curl * curl / area[lane];
        sums.divergence += divergence * divergence / area[lane];
        sums.mixed += curl * divergence / area[lane];
      }
    }
    return sums;
  });
}

bool is_one_sided(const PhaseGraph& graph) {
  return ranges::none_of(graph.reflecting, [](std::uint8_t edge) { return edge != 0; });
}

bool turns_freely(const PhaseGraph& graph, int symmetry) {
  const bool is_pulled =
      ranges::any_of(graph.anchor, [](const Complex& pull) { return pull != Complex(0); });
  return symmetry <= 2 && !is_pulled && is_one_sided(graph);
}

bool is_much_curled(const CurlSums& sums) {
  // The sums do not depend on scale. Far above rounding, and above curls too small to bend stripes.
  constexpr double kShown = 0.1;
  const double mean = (sums.curl + sums.divergence) / 2, half = (sums.curl - sums.divergence) / 2;
  const double least = mean - std::sqrt(half * half + sums.mixed * sums.mixed);
  return sums.curl > kShown && least < 0.5 * sums.curl;
}

float least_curl_angle(const CurlSums& sums) {
  const double twice = elementary::atan2(-sums.mixed, (sums.divergence - sums.curl) / 2);
  return static_cast<float>(twice / 2);
}

void turn_to_least_curl(const CurlSums& sums, bool new_found, std::span<const Vec3> normals,
                        DirectionField& directions) {
  if (!new_found && !is_much_curled(sums)) return;
  directions = rotated(directions, normals, least_curl_angle(sums));
}

}  // namespace brindle
