/// The paper's local optimisation (3.2, 3.3 and section 4).
#pragma once

#include <span>
#include <vector>

#include "brindle/phases/sliced_graph.h"
#include "brindle/solver.h"

namespace brindle {

/// The order in which a graph is relaxed: coloured as the paper does, neighbours close together.
SlicedLayout relaxation_layout(const Adjacency& adjacency, std::uint32_t seed,
                               const Progress& progress = {});

/// The phases that a relaxation starts from, by slot: `start` (one unit number per node), or the
/// hashed random start if that is empty.
std::vector<Complex> start_phases(const SlicedLayout& layout, std::span<const Complex> start,
                                  std::uint32_t seed);

/// Iterates Eq. 8 to 11 colour by colour from `start` (one unit number per node; empty for the
/// hashed random start) until the relative energy improvement (Eq. 12) drops below
/// `options.epsilon`.
PhaseSolution relax(const PhaseGraph& graph, const SolverOptions& options,
                    std::span<const Complex> start = {}, const Progress& progress = {});

}  // namespace brindle
