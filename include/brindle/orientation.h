/// Consistent signs of directions that are defined up to sign.
#pragma once

#include <cstdint>
#include <span>

#include "brindle/direction_field.h"
#include "brindle/export.h"
#include "brindle/progress.h"
#include "brindle/surface.h"
#include "brindle/types.h"

namespace BRINDLE_EXPORT brindle {

/// Reverses directions, breadth-first from the first vertex of every component, so that each runs
/// like the neighbours visited before. Patterns do not depend on signs, but solvers are faster with
/// few reflecting edges. Where no consistent choice exists, some edges stay reflecting.
/// `directions` has one entry per vertex. Throws Cancelled if `progress` cancels; some directions
/// are reversed then.
void orient_alike(const Adjacency& neighborhood, std::span<Vec3> directions,
                  const Progress& progress = {});

/// As above over a whole surface: on the two sides of a crease, directions run alike once it is
/// unfolded.
void orient_alike(const Surface& surface, std::span<Vec3> directions,
                  const Progress& progress = {});

/// As above, starting from settled directions (1), which do not change.
void orient_alike(const Adjacency& neighborhood, std::span<const std::uint8_t> settled,
                  std::span<Vec3> directions);

/// Reverses directions that run against `reference`, which has one entry per direction.
void orient_like(std::span<const Vec3> reference, std::span<Vec3> directions);

}  // namespace brindle
