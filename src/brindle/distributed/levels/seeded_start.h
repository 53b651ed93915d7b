/// Where smooth fields of surfaces begin that are too large to be planned on rank 0.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "brindle/communicator.h"
#include "brindle/distributed/levels/rank_graph.h"
#include "brindle/phase_graph.h"
#include "brindle/phases/several_starts.h"
#include "brindle/types.h"

namespace brindle {

/// Collective. Phases of own nodes and ghosts that do not depend, but for rounding, on which rank
/// has which node: those of a coarse graph, which rank 0 solves. Its nodes are the cells of seeds,
/// which the nodes' numbers choose, some 16,384 at most; every node is led to a seed along the
/// fewest edges. Solutions of large graphs are free to turn as a whole and to choose among many
/// minima; ranks that start here end in the same one. `couplings` has rows of own nodes; `ids` are
/// their numbers in the whole.
LowestPhases seeded_start(Communicator& ranks, const RankGraph& graph, const PhaseGraph& couplings,
                          std::span<const std::uint64_t> ids, Starts starts, int sweeps,
                          int cycles);

}  // namespace brindle
