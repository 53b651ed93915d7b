/// The paper's optimisation: locally (3.2, 3.3 and section 4) and over its hierarchy of averaged
/// inputs (3.4).
#pragma once

#include <span>
#include <vector>

#include "brindle/phases/sliced_graph.h"
#include "brindle/solver.h"

namespace brindle {

/// The order in which a graph is relaxed: the paper's colours, neighbours close together.
SlicedLayout relaxation_layout(const Adjacency& adjacency, std::uint32_t seed,
                               const Progress& progress = {});

/// The start of a relaxation, by slot: `start` (one unit number per node), or the hashed random
/// start if that is empty.
std::vector<Complex> start_phases(const SlicedLayout& layout, std::span<const Complex> start,
                                  std::uint32_t seed);

/// Iterates Eq. 8 to 11 colour by colour from `start` (one unit number per node; empty: the hashed
/// random start) until the relative energy improvement (Eq. 12) drops below `options.epsilon`.
/// Throws Cancelled if `progress` asks for it.
PhaseSolution relax(const PhaseGraph& graph, const SolverOptions& options,
                    std::span<const Complex> start = {}, const Progress& progress = {});

/// Relaxes the coarsest of the graph's averaged levels from a random start, then passes the phases
/// down level by level and relaxes each until it has converged. Throws Error if there are no
/// levels.
PhaseSolution solve_averaged(const PhaseGraph& graph, std::span<const AveragedLevel> levels,
                             const SolverOptions& options, const Progress& progress = {});

}  // namespace brindle
