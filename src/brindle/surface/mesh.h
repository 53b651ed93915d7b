/// A triangle surface: points and triangles, of any topology.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "brindle/base/types.h"

namespace brindle {

/// Three vertex numbers, counter-clockwise seen from outside where the surface has an outside.
using Triangle = std::array<Index, 3>;

/// A triangle mesh. Nothing is asked of its topology: it may be open, non-manifold, unorientable,
/// or in pieces, and may have vertices that no triangle uses. Positions are finite and triangle
/// corners in range and different from each other; `repair_mesh` (mesh_repair.h) sees to that.
struct Mesh {
  std::vector<Vec3> positions;  ///< relative to `origin`
  std::vector<Triangle> triangles;
  /// Where the positions' zero stands. Floats lose the shape of what is small and far from zero, so
  /// files with such coordinates are read relative to a point nearby and written back in place.
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();

  std::size_t vertex_count() const { return positions.size(); }
  std::size_t triangle_count() const { return triangles.size(); }
};

/// Corners of the axis-aligned box around all vertices that a triangle uses, or around all vertices
/// if there is no triangle; both zero if there is no vertex.
struct BoundingBox {
  Vec3 lower = Vec3::Zero();
  Vec3 upper = Vec3::Zero();

  Vec3 center() const { return 0.5f * (lower + upper); }
  float diagonal() const { return (upper - lower).norm(); }
};

BoundingBox bounding_box(const Mesh& mesh);

}  // namespace brindle
