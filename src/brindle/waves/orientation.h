/// Signs of directions that are meant up to sign.
#pragma once

#include <span>

#include "brindle/adjacency.h"
#include "brindle/direction_field.h"

namespace brindle {

/// Turns directions round, breadth-first from the first of every component, so that each runs like
/// the neighbours visited before it. The pattern does not depend on signs; solvers are faster where
/// few edges reflect. Where no consistent choice exists, some edges stay reflecting.
void orient_alike(const Adjacency& neighborhood, std::span<Vec3> directions);

/// Turns round those directions that run against `reference` (one per direction).
void orient_like(std::span<const Vec3> reference, std::span<Vec3> directions);

}  // namespace brindle
