/// How often a mesh can be subdivided.
#pragma once

#include <cstddef>

namespace brindle {

/// Throws Error if `times` is negative, or the result would have more triangles than brindle can
/// number.
void check_subdivisions(std::size_t triangles, int times);

}  // namespace brindle
