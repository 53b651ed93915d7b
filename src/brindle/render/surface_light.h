/// Lightness of surface points.
#pragma once

#include "brindle/camera.h"

namespace brindle {

/// Unit vectors towards the lights of a picture, in the camera's coordinates.
struct Lights {
  Vec3 key;   ///< the brightest
  Vec3 fill;  ///< a weak one from the opposite side
  Vec3 sky;   ///< upwards
};

/// The lights of a picture from this camera.
Lights lights_of(const Camera& camera, const PictureLight& light);

/// Twin of tone.glsl: the lightness of a white surface at a point, 0 to 1. `view_normal` (unit, of
/// the visible side) and `sight` (from the viewer, any length) are in camera coordinates.
float tone_at(const Vec3& view_normal, const Vec3& sight, const Lights& lights);

}  // namespace brindle
