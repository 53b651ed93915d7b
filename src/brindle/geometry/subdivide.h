/// Limits on the subdivision of meshes, also of distributed ones.
#pragma once

#include <cstddef>

namespace brindle {

/// Throws Error if `times` is negative, or the result would have more triangles than brindle can
/// number, or than memory holds.
void check_subdivisions(std::size_t triangles, int times);

}  // namespace brindle
