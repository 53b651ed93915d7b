/// How light a point of a surface is.
#pragma once

#include "brindle/camera.h"

namespace brindle {

/// Unit vectors towards the lights of a picture, in the camera's coordinates.
struct Lights {
  Vec3 key;   ///< the brightest
  Vec3 fill;  ///< a weak one from the other side
  Vec3 sky;   ///< upwards
};

/// The lights of a picture from this camera.
Lights lights_of(const Camera& camera, const PictureLight& light);

/// The twin of tone.glsl: how light a white surface is at a point, 0 to 1. The unit normal of the
/// side that is seen and the way from the viewer to the point (of any length) are in the camera's
/// coordinates.
float tone_at(const Vec3& view_normal, const Vec3& sight, const Lights& lights);

}  // namespace brindle
