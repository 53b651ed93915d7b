/// Light of surface points and of pixels.
#pragma once

#include <algorithm>

#include "brindle/camera.h"
#include "brindle/image.h"
#include "brindle/mesh.h"

namespace brindle {

/// Unit vectors towards the lights of a picture, in the camera's coordinates.
struct Lights {
  Vec3 key;   ///< the brightest
  Vec3 fill;  ///< a weak one from the opposite side
  Vec3 sky;   ///< upwards
};

/// The lights of a picture from this camera.
Lights lights_of(const Camera& camera, const PictureLight& light);

/// Twin of tone_at in strokes.glsl: the lightness of a white surface at a point, 0 to 1.
/// `view_normal` (unit, of the visible side) and `sight` (from the viewer, any length) are in
/// camera coordinates.
float tone_at(const Vec3& view_normal, const Vec3& sight, const Lights& lights);

/// The pixel of linear light, premultiplied by alpha; the inverse of `premultiplied_light`.
Pixel pixel_of(const Eigen::Vector4f& light);

/// 0 up to `from`, 1 from `to` on, and smooth in between.
inline float smooth_step(float from, float to, float x) {
  const float t = std::clamp((x - from) / (to - from), 0.0f, 1.0f);
  return t * t * (3 - 2 * t);
}

// Surfaces with one visible side.

enum class HiddenSide { none, back, front };

/// The side of all triangles that is invisible from outside. It exists if the mesh is closed and
/// consistently wound, and the volumes of its connected components have the same sign. (Surfaces
/// that intersect themselves inside out are not detected.)
HiddenSide hidden_side(const Mesh& mesh);

}  // namespace brindle
