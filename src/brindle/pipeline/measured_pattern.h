/// What follows from a pattern's phases.
#pragma once

#include <cstddef>
#include <span>

#include "brindle/stripe_pattern.h"

namespace brindle {

/// How many stripes begin or end in triangles where that is unwelcome; `calm` is by vertex.
std::size_t count_in_calm(std::span<const Triangle> triangles,
                          std::span<const CornerPhases> corners, std::span<const float> calm);

}  // namespace brindle
