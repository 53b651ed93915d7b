/// Pairs of singularities that undo each other.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "brindle/surface.h"
#include "brindle/types.h"

namespace brindle {

/// Two triangles that a field turns round in opposite senses.
struct OppositeSingularities {
  Index positive;
  Index negative;
  float distance;  ///< along edges, in periods
};

struct FoundSingularities {
  std::size_t count = 0;
  std::vector<OppositeSingularities> pairs;  ///< the nearest first, each triangle in one at most
};

/// The singularities of a field of symmetry N, and those nearer to an opposite one than so many
/// periods of stripes with these frequencies. One direction and frequency per vertex.
FoundSingularities opposite_singularities(const Surface& surface, std::span<const Vec3> directions,
                                          int symmetry, std::span<const float> frequencies,
                                          float reach);

}  // namespace brindle
