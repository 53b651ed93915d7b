/// What anchors add to the phase graph of a smooth field.
#pragma once

#include <cstddef>

#include "brindle/strokes.h"
#include "brindle/types.h"

namespace brindle {

/// Throws Error for a vertex out of range, and for a direction or weight that is not finite.
void check_field_anchor(const FieldAnchor& anchor, std::size_t vertices);

/// What the anchor adds to its vertex's T_i, for a field of symmetry N.
Complex pull_of(const FieldAnchor& anchor, const Adjacency& neighborhood, const Vec3& normal,
                int symmetry);

}  // namespace brindle
