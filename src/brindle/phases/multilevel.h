/// The multilevel solver: descends a hierarchy of exact sums (DESIGN section 3).
#pragma once

#include "brindle/phases/hierarchy.h"

namespace brindle {

/// From the coarsest level down: prolong the phases, then `sweeps` coloured sweeps, more on small
/// levels. Phases end in `hierarchy.levels[0].z`. No random start and nothing to tune; each sweep
/// can only lower the energy.
void descend(Hierarchy& hierarchy, int sweeps);

/// Another descent from the phases that the finest level has: they become its gauges, so that a
/// coarse unknown turns the phases of its aggregate, and not turning (Z = 1) is where every level
/// starts. The energy cannot rise. Overwrites gauges and coarse couplings; the next `renew`
/// restores them.
void correct(Hierarchy& hierarchy, int sweeps);

}  // namespace brindle
