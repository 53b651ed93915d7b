/// Lightness of surfaces in a picture.
#pragma once

#include <span>
#include <vector>

#include "brindle/camera.h"
#include "brindle/export.h"
#include "brindle/mesh.h"

namespace BRINDLE_EXPORT brindle {

/// Lightness of a white surface at each vertex in a picture from this camera, from 0 (black) to 1
/// (white), perceptually even: the tones that strokes follow (`ToneRange`). Uses the outer side of
/// closed surfaces; the visible side of others, and with a slice. Normals have one unit vector per
/// vertex; a zero normal gives NaN. Throws Error unless there is one per vertex.
std::vector<float> surface_tones(const Mesh& mesh, std::span<const Vec3> normals,
                                 const Camera& camera, const PictureLight& light);

}  // namespace brindle
