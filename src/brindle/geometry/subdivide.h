/// How often a mesh can be subdivided.
#pragma once

#include <cstddef>
#include <vector>

#include "brindle/progress.h"

namespace brindle {

/// Throws Error if `times` is negative, or the result would have more triangles than brindle can
/// number.
void check_subdivisions(std::size_t triangles, int times);

/// A stage for each time that a mesh is subdivided, four times as long as the one before.
std::vector<JobStage> subdivision_rounds(int times);

}  // namespace brindle
