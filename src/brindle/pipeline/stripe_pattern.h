/// The main job: from a surface with waves to a measured stripe pattern.
#pragma once

#include <functional>

#include "brindle/geometry/surface.h"
#include "brindle/pattern/quality.h"
#include "brindle/phases/solver.h"
#include "brindle/progress.h"

namespace brindle {

/// What multiplies the paper's weight |<d_i, d_j>| of an edge.
enum class EdgeWeights {
  paper,     ///< nothing
  cotangent  ///< `cotangent_weights`: lower angle errors for a longer coupling stage
};

/// Turns a phase graph into phases, as `solve_phases` and `GpuSolver::solve` of brindle/gpu do.
using SolvePhases =
    std::function<PhaseSolution(const PhaseGraph&, const SolverOptions&, const Progress&)>;

struct StripeOptions {
  PhaseShiftKind phase_shift = PhaseShiftKind::aligned;
  EdgeWeights weights = EdgeWeights::paper;
  SolverOptions solver;
  SolvePhases solve;  ///< empty: on the processor
};

/// Wall-clock milliseconds a stage; `load` is left to whoever reads the mesh.
struct StripeMilliseconds {
  double load = 0;
  double topology = 0;  ///< neighbourhood and normals, colours, aggregates: once per connectivity
  double couple = 0;    ///< phase shifts
  double solve = 0;
  double pattern = 0;  ///< corner phases and quality
};

struct StripePattern {
  WaveSet waves;
  PhaseSolution solution;             ///< `solution.z`: one phase per vertex
  std::vector<CornerPhases> corners;  ///< one entry per triangle
  PatternQuality quality;
  StripeMilliseconds milliseconds;
};

/// Couples the waves along the edges of the surface, solves for phases, lifts them to the corners
/// of the triangles and measures the result; on points without triangles as `measure_point_quality`
/// does. `waves` has one entry per vertex. Throws Error for waves that `check_waves` refuses, and
/// what `solve_phases` throws.
StripePattern stripe_pattern(const Surface& surface, WaveSet waves,
                             const StripeOptions& options = {}, const Progress& progress = {});

/// Throws Error unless `waves` has one entry for each of the surface's vertices, for values that
/// `check_waves` (wave_check.h) refuses, and for directions that stick out of the tangent plane by
/// more than 4 degrees: a quarter turn about the normal would not leave them as long as they are.
void check_tangent_waves(const Surface& surface, const WaveSet& waves);

}  // namespace brindle
