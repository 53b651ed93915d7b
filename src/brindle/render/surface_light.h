/// How light a point of a surface is.
#pragma once

#include "brindle/types.h"

namespace brindle {

/// The twin of tone.glsl: how light a white surface is at a point, 0 to 1. The unit normal of the
/// side that is seen, the way from the viewer to the point (of any length) and the direction
/// upwards are those of the camera's coordinates.
float tone_at(const Vec3& view_normal, const Vec3& sight, const Vec3& up);

}  // namespace brindle
