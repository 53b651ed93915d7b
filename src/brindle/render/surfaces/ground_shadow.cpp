#include "brindle/render/surfaces/ground_shadow.h"

#include <algorithm>
#include <array>

namespace brindle {
namespace {

constexpr int kShadowSide = GroundShadow::kSide;
using Grid = std::vector<float>;

float cross_of(const Eigen::Vector2f& a, const Eigen::Vector2f& b) {
  return a.x() * b.y() - a.y() * b.x();
}

/// Marks the cells whose middle the triangle covers, and the cells of its corners.
void cover_cells(const std::array<Eigen::Vector2f, 3>& corners, Grid& grid) {
  const Eigen::Vector2f lower = corners[0].cwiseMin(corners[1]).cwiseMin(corners[2]);
  const Eigen::Vector2f upper = corners[0].cwiseMax(corners[1]).cwiseMax(corners[2]);
  const auto cell = [](float place) {
    return std::clamp(static_cast<int>(place), 0, kShadowSide - 1);
  };
  const auto at = [&](int x, int y) -> float& {
    return grid[static_cast<std::size_t>(y) * kShadowSide + static_cast<std::size_t>(x)];
  };
  for (const Eigen::Vector2f& corner : corners) at(cell(corner.x()), cell(corner.y())) = 1;
  const float area = cross_of(corners[1] - corners[0], corners[2] - corners[0]);
  if (area == 0) return;
  for (int y = cell(lower.y()); y <= cell(upper.y()); ++y) {
    for (int x = cell(lower.x()); x <= cell(upper.x()); ++x) {
      const Eigen::Vector2f middle(static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f);
      const float u = cross_of(corners[1] - middle, corners[2] - middle) / area;
      const float v = cross_of(corners[2] - middle, corners[0] - middle) / area;
      if (u >= 0 && v >= 0 && u + v <= 1) at(x, y) = 1;
    }
  }
}

/// Three box filters of 2 `radius` + 1 cells along x and y: nearly Gaussian.
void blur(Grid& grid, int radius) {
  Grid line(kShadowSide);
  for (int pass = 0; pass < 6; ++pass) {
    const std::size_t step = pass % 2 == 0 ? 1 : kShadowSide;
    const std::size_t stride = pass % 2 == 0 ? kShadowSide : 1;
    for (std::size_t row = 0; row < kShadowSide; ++row) {
      for (int i = 0; i < kShadowSide; ++i) {
        float sum = 0;
        for (int k = std::max(0, i - radius); k <= std::min(kShadowSide - 1, i + radius); ++k) {
          sum += grid[row * stride + static_cast<std::size_t>(k) * step];
        }
        line[static_cast<std::size_t>(i)] = sum / static_cast<float>(2 * radius + 1);
      }
      for (std::size_t i = 0; i < kShadowSide; ++i) grid[row * stride + i * step] = line[i];
    }
  }
}

}  // namespace

Mesh left_by(const Eigen::Hyperplane<float, 3>& slice, const Mesh& mesh) {
  Mesh left;
  left.origin = mesh.origin;
  left.positions = mesh.positions;
  for (const Triangle& t : mesh.triangles) {
    // The kept corners and the intersections with the plane, in winding order.
    std::vector<Index> corners;
    for (std::size_t m = 0; m < 3; ++m) {
      const Vec3 &a = mesh.positions[t[m]], &b = mesh.positions[t[(m + 1) % 3]];
      const float from = slice.signedDistance(a), to = slice.signedDistance(b);
      if (from <= 0) corners.push_back(t[m]);
      if ((from <= 0) == (to <= 0)) continue;
      corners.push_back(static_cast<Index>(left.positions.size()));
      left.positions.push_back(a + from / (from - to) * (b - a));
    }
    for (std::size_t m = 2; m < corners.size(); ++m) {
      left.triangles.push_back({corners[0], corners[m - 1], corners[m]});
    }
  }
  return left;
}

GroundShadow ground_shadow(std::span<const Vec3> points, std::span<const Triangle> triangles,
                           const Eigen::Matrix3f& axes) {
  constexpr float kRoom = 0.3f;  // of the longer side
  GroundShadow shadow;
  if (points.empty()) return shadow;
  std::vector<Vec3> places;
  Vec3 lower = axes.transpose() * points[0], upper = lower;
  for (const Vec3& point : points) {
    places.push_back(axes.transpose() * point);
    lower = lower.cwiseMin(places.back());
    upper = upper.cwiseMax(places.back());
  }
  const float side = std::max((upper - lower).head<2>().maxCoeff(), 1e-6f);
  shadow.size = Eigen::Vector2f::Constant(side * (1 + 2 * kRoom));
  shadow.lower = 0.5f * (lower + upper).head<2>() - 0.5f * shadow.size;
  shadow.height = lower.z();
  // Parts near the ground cast a sharper and darker shadow.
  const float near = lower.z() + 0.18f * (upper.z() - lower.z());
  Grid all(static_cast<std::size_t>(kShadowSide) * kShadowSide), close = all;
  const float scale = kShadowSide / shadow.size.x();
  for (const Triangle& t : triangles) {
    std::array<Eigen::Vector2f, 3> corners;
    float lowest = places[t[0]].z();
    for (std::size_t m = 0; m < 3; ++m) {
      corners[m] = scale * (places[t[m]].head<2>() - shadow.lower);
      lowest = std::min(lowest, places[t[m]].z());
    }
    cover_cells(corners, all);
    if (lowest < near) cover_cells(corners, close);
  }
  blur(all, 9);
  blur(close, 3);
  for (std::size_t i = 0; i < all.size(); ++i) {
    shadow.missing.push_back(0.30f * all[i] + 0.38f * close[i]);
  }
  return shadow;
}

}  // namespace brindle
