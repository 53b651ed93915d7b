/// Detection of triangles that intersect others of the same mesh.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "brindle/mesh.h"
#include "brindle/progress.h"

namespace brindle {

/// 1 for every triangle that an edge of another one crosses, or whose edge crosses another one,
/// away from common vertices. Triangles that only touch do not intersect, within the rounding of
/// coordinates. With `tested`, only triangles with a 1 there are compared with all others. Throws
/// Cancelled if `progress` cancels.
std::vector<std::uint8_t> intersecting_triangles(const Mesh& mesh, const Progress& progress = {},
                                                 std::span<const std::uint8_t> tested = {});

}  // namespace brindle
