/// Normals of a surface in pieces as it is seen from farther away.
#pragma once

#include <span>
#include <vector>

#include "brindle/distributed/surface/rank_surface.h"
#include "brindle/phases/screened.h"
#include "brindle/types.h"

namespace brindle {

/// Collective. For each of `radii`, as `averaged_normals` of the whole has them but for rounding,
/// those of all vertices here.
std::vector<std::vector<Vec3>> averaged_normals(const RankSurface& surface,
                                                std::span<const float> radii);

/// Collective. The same to the bit, where triangles have numbers: rank 0 gets the whole.
std::vector<std::vector<Vec3>> averaged_on_first(const RankSurface& surface,
                                                 std::span<const float> radii);

/// Collective, as long as the surface and its ranks are there: what a solver is to know of them.
ScreenedOptions part_of_ranks(const RankSurface& surface);

}  // namespace brindle
