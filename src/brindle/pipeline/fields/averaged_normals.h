/// Normals of a surface as it is seen from farther away.
#pragma once

#include <span>
#include <vector>

#include "brindle/progress.h"
#include "brindle/surface.h"

namespace brindle {

/// For each of `radii`, which ascend, in units of length and above 0, the surface's normals
/// averaged over places whose root mean square distance it is; of unit length. Zero where the
/// surface's are, and the surface's own where their average has no direction. A finer mesh has the
/// same. Throws Cancelled if `progress` asks for it.
std::vector<std::vector<Vec3>> averaged_normals(const Surface& surface,
                                                std::span<const float> radii,
                                                const Progress& progress = {});

}  // namespace brindle
