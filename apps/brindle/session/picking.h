/// Finds the surface point under a pixel, and its values.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "brindle/camera.h"
#include "brindle/surface.h"
#include "session/live_pattern.h"

namespace brindle::tool {

struct PickedPoint {
  std::size_t triangle;
  Vec3 barycentric;       ///< in that triangle; not negative, sums to 1
  Vec3 position;          ///< relative to the mesh's origin
  Vec3 normal;            ///< of the triangle, unit, towards the viewer
  Eigen::Vector3d place;  ///< in file coordinates, for strokes
  float depth;            ///< along the viewing direction
};

/// The nearest hit at `x`, `y` in pixels from the upper left corner of a picture of `width` x
/// `height`; pixel centres are at 0.5. Watertight along edges and at vertices. Ignores what the
/// camera's slice cuts away. Empty for points without triangles.
std::optional<PickedPoint> pick(const Surface& surface, const Camera& camera, int width, int height,
                                double x, double y);

/// The pixel of a position relative to the mesh's origin; empty behind the viewer.
std::optional<Eigen::Vector2d> place_in_picture(const Vec3& position, const Camera& camera,
                                                int width, int height);

struct PickedValue {
  std::string name;  ///< "frequency", or an array's name
  std::string text;
};

/// The point in file coordinates, its wave, and the values of the file's arrays. `point` was picked
/// on this state's surface.
std::vector<PickedValue> values_at(const LiveState& state, const PickedPoint& point);

}  // namespace brindle::tool
