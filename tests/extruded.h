/// Parts with flat faces and sharp edges, as programs for engineers draw them: few long triangles.
#pragma once

#include <cmath>
#include <cstddef>
#include <numbers>
#include <utility>
#include <vector>

#include "brindle/creases.h"
#include "brindle/mesh.h"
#include "brindle/surface.h"

namespace brindle {

using Outline = std::vector<Eigen::Vector2f>;

/// A circle of so many corners, every second one at `inner` times the radius.
inline Outline toothed_circle(int corners, float radius, float inner = 1) {
  Outline outline;
  for (int k = 0; k < corners; ++k) {
    const float angle =
        2 * std::numbers::pi_v<float> * static_cast<float>(k) / static_cast<float>(corners);
    outline.push_back((k % 2 == 0 ? radius : inner * radius) *
                      Eigen::Vector2f(std::cos(angle), std::sin(angle)));
  }
  return outline;
}

/// A square with as many corners as a circle has that is seen from its middle.
inline Outline square_round(int corners, float half) {
  Outline outline;
  for (const Eigen::Vector2f& p : toothed_circle(corners, 1)) {
    outline.push_back(half / std::max(std::abs(p.x()), std::abs(p.y())) * p);
  }
  return outline;
}

/// A plate from z = 0 to `height` between two outlines of as many corners, the hole inside the
/// other.
inline Mesh extruded_ring(const Outline& rim, const Outline& hole, float height) {
  const auto count = static_cast<Index>(rim.size());
  Mesh mesh;
  for (const float z : {0.0f, height}) {
    for (const Outline* outline : {&rim, &hole}) {
      for (const Eigen::Vector2f& p : *outline) mesh.positions.push_back({p.x(), p.y(), z});
    }
  }
  const auto at = [&](Index layer, Index ring, Index k) {
    return (2 * layer + ring) * count + k % count;
  };
  const auto quad = [&](Index a, Index b, Index c, Index d) {
    mesh.triangles.push_back({a, b, c});
    mesh.triangles.push_back({a, c, d});
  };
  for (Index k = 0; k < count; ++k) {
    quad(at(0, 1, k), at(0, 1, k + 1), at(0, 0, k + 1), at(0, 0, k));
    quad(at(1, 0, k), at(1, 0, k + 1), at(1, 1, k + 1), at(1, 1, k));
    quad(at(0, 0, k), at(0, 0, k + 1), at(1, 0, k + 1), at(1, 0, k));
    quad(at(0, 1, k + 1), at(0, 1, k), at(1, 1, k), at(1, 1, k + 1));
  }
  return mesh;
}

/// The same without a hole.
inline Mesh extruded(const Outline& rim, float height) {
  const auto count = static_cast<Index>(rim.size());
  Mesh mesh;
  for (const float z : {0.0f, height}) {
    for (const Eigen::Vector2f& p : rim) mesh.positions.push_back({p.x(), p.y(), z});
    mesh.positions.push_back({0, 0, z});
  }
  const Index upper = count + 1;
  for (Index k = 0; k < count; ++k) {
    const Index next = (k + 1) % count;
    mesh.triangles.push_back({next, k, count});
    mesh.triangles.push_back({upper + k, upper + next, upper + count});
    mesh.triangles.push_back({k, next, upper + next});
    mesh.triangles.push_back({k, upper + next, upper + k});
  }
  return mesh;
}

inline Surface with_creases(Mesh mesh, float angle_deg = kCreaseAngle) {
  Creases creases = split_at_creases(mesh, angle_deg);
  return make_surface(std::move(mesh), std::move(creases));
}

}  // namespace brindle
