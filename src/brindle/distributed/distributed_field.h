/// Smooth fields over ranks with other bounds than the usual ones.
#pragma once

#include "brindle/distributed/levels/distributed_hierarchy.h"
#include "brindle/distributed_surface.h"

namespace brindle {

DirectionField smooth_direction_field(const DistributedSurface& surface,
                                      const SmoothFieldOptions& options, HierarchyBounds bounds);

}  // namespace brindle
