/// The multilevel solver on waves, coupled straight into its own order.
#pragma once

#include <span>

#include "brindle/phase_graph.h"
#include "brindle/solver.h"

namespace brindle {

struct WaveSolution {
  PhaseSolution solution;
  double couple_milliseconds = 0;  ///< waves into the solver's order, phase shifts
};

/// The phases that `solve_phases` finds with Solver::multilevel on `build_phase_graph(adjacency,
/// waves, kind, edge_weights)`, in less time and memory. `kind` is aligned or trapezoid: the
/// paper's common source goes through a PhaseGraph. Throws Error for waves that `check_waves`
/// refuses, sizes that do not match and options out of range; Cancelled if `progress` asks for it.
WaveSolution solve_multilevel_waves(const Adjacency& adjacency, const WaveSet& waves,
                                    PhaseShiftKind kind, std::span<const float> edge_weights,
                                    const SolverOptions& options, const Progress& progress = {});

}  // namespace brindle
