/// Signs of directions that are meant up to sign.
#pragma once

#include <cstdint>
#include <span>

#include "brindle/direction_field.h"
#include "brindle/export.h"
#include "brindle/progress.h"
#include "brindle/types.h"

namespace BRINDLE_EXPORT brindle {

/// Turns directions round, breadth-first from the first of every component, so that each runs like
/// the neighbours visited before it. The pattern does not depend on signs; solvers are faster where
/// few edges reflect. Where no consistent choice exists, some edges stay reflecting. Throws
/// Cancelled if `progress` asks for it, with some directions turned.
void orient_alike(const Adjacency& neighborhood, std::span<Vec3> directions,
                  const Progress& progress = {});

/// The same of directions that are not settled, from those that are (1), which stay as they are.
void orient_alike(const Adjacency& neighborhood, std::span<const std::uint8_t> settled,
                  std::span<Vec3> directions);

/// Turns round those directions that run against `reference` (one per direction).
void orient_like(std::span<const Vec3> reference, std::span<Vec3> directions);

}  // namespace brindle
