/// How light surfaces are in a picture.
#pragma once

#include <span>
#include <vector>

#include "brindle/camera.h"
#include "brindle/export.h"
#include "brindle/mesh.h"

namespace BRINDLE_EXPORT brindle {

/// How light a white surface is at each vertex in a picture from this camera, from 0 (black) to 1
/// (white), even to the eye: the tones that strokes follow (`ToneRange`). Of closed surfaces it is
/// the outer side; of others, and with a slice, the side that is seen. Normals have one unit vector
/// per vertex, and NaN is the tone where one is zero. Throws Error if there is not one per vertex.
std::vector<float> surface_tones(const Mesh& mesh, std::span<const Vec3> normals,
                                 const Camera& camera, const PictureLight& light);

}  // namespace brindle
