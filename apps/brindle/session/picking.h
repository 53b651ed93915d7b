/// What of a surface is under a pixel.
#pragma once

#include <cstddef>
#include <optional>

#include "brindle/camera.h"
#include "brindle/surface.h"

namespace brindle::tool {

struct PickedPoint {
  std::size_t triangle;
  Vec3 barycentric;       ///< in that triangle; not negative, sums to 1
  Vec3 position;          ///< relative to the mesh's origin
  Vec3 normal;            ///< of the triangle, unit, towards the viewer
  Eigen::Vector3d place;  ///< in the coordinates of the mesh's file: what strokes are made of
  float depth;            ///< along the viewing direction
};

/// The nearest hit of the surface at `x`, `y` in pixels from the upper left corner of a picture of
/// `width` x `height`; pixel centres are at 0.5. Nothing is missed between triangles with a common
/// edge. What the camera's slice takes away is not hit. Nothing for points without triangles.
std::optional<PickedPoint> pick(const Surface& surface, const Camera& camera, int width, int height,
                                double x, double y);

/// Where a position, relative to the mesh's origin, is in the picture; nothing behind the viewer.
std::optional<Eigen::Vector2d> place_in_picture(const Vec3& position, const Camera& camera,
                                                int width, int height);

}  // namespace brindle::tool
