/// Normals of a surface as it is seen from farther away.
#pragma once

#include <vector>

#include "brindle/progress.h"
#include "brindle/surface.h"

namespace brindle {

/// The surface's normals, averaged over places whose root mean square distance is `radius`, in
/// units of length and above 0; of unit length. Zero where the surface's are, and the surface's own
/// where their average has no direction. A finer mesh has the same. Throws Cancelled if `progress`
/// asks for it.
std::vector<Vec3> averaged_normals(const Surface& surface, float radius,
                                   const Progress& progress = {});

}  // namespace brindle
