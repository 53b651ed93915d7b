/// The paper's optimisation: the local method (3.2, 3.3 and section 4) and the hierarchy of
/// averaged inputs (3.4).
#pragma once

#include <span>
#include <vector>

#include "brindle/phases/sliced_graph.h"
#include "brindle/solver.h"

namespace brindle {

/// The layout for relaxation: the paper's colours, with neighbours close together.
SlicedLayout relaxation_layout(const Adjacency& adjacency, std::uint32_t seed,
                               const Progress& progress = {});

/// The start of a relaxation, by slot: `start` (one unit number per node), or the hashed random
/// start if `start` is empty.
std::vector<Complex> start_phases(const SlicedLayout& layout, std::span<const Complex> start,
                                  std::uint32_t seed);

/// Iterates Eq. 8 to 11 colour by colour until the relative energy improvement (Eq. 12) falls below
/// `options.epsilon`. Starts from `start` (one unit number per node), or from the hashed random
/// start if that is empty. Throws Cancelled if `progress` cancels.
PhaseSolution relax(const PhaseGraph& graph, const SolverOptions& options,
                    std::span<const Complex> start = {}, const Progress& progress = {});

/// Relaxes the coarsest averaged level of the graph from a random start. Then passes the phases
/// down and relaxes each level until it converges. Throws Error if there are no levels.
PhaseSolution solve_averaged(const PhaseGraph& graph, std::span<const AveragedLevel> levels,
                             const SolverOptions& options, const Progress& progress = {});

}  // namespace brindle
