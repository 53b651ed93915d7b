/// The multilevel solver: descends a hierarchy of exact sums (DESIGN section 3).
#pragma once

#include "brindle/phases/hierarchy.h"

namespace brindle {

/// From the coarsest level down: prolong the phases, then `sweeps` coloured sweeps. Phases end in
/// `hierarchy.levels[0].z`. No random start and nothing to tune; each sweep can only lower the
/// energy.
void descend(Hierarchy& hierarchy, int sweeps);

}  // namespace brindle
