/// Stripe patterns: from a surface with waves to measured phases.
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "brindle/curve_measures.h"
#include "brindle/curves.h"
#include "brindle/direction_field.h"
#include "brindle/export.h"
#include "brindle/frequency_field.h"
#include "brindle/progress.h"
#include "brindle/quality.h"
#include "brindle/samples.h"
#include "brindle/solver.h"
#include "brindle/spacing_tolerance.h"
#include "brindle/surface.h"

namespace BRINDLE_EXPORT brindle {

/// Factors of the paper's edge weight |<d_i, d_j>|.
enum class EdgeWeights {
  paper,     ///< 1
  cotangent  ///< `cotangent_weights`: lower angle errors, slower coupling
};

/// Turns a phase graph into phases, as `solve_phases` and `GpuSolver::solve` do.
using SolvePhases = std::function<PhaseSolution(const PhaseGraph&, const SolverOptions&,
                                                const Progress&, const SolverData&)>;

/// Options of `stripe_pattern`.
struct StripeOptions {
  PhaseShiftKind phase_shift = PhaseShiftKind::aligned;
  EdgeWeights weights = EdgeWeights::paper;
  SolverOptions solver;
  SolvePhases solve;  ///< empty: on the processor
  /// Phases to stay near: a unit number per vertex, 0 if unknown, as from `matched_phases` and
  /// `carried_phases`; empty: none. For Solver::multilevel.
  std::vector<Complex> last_phases;
  float lambda = 0.025f;  ///< strength of `last_phases`, as in AnimatorOptions; 0: ignored
  Slack slack = 0;        ///< spacing tolerance (spacing_tolerance.h); 0: none
  /// Fixed phases of the result: a unit number per vertex, 0 where free, as from `boundary_phases`;
  /// empty: none. For Solver::multilevel.
  std::vector<Complex> fixed_phases;
};

/// Wall-clock milliseconds per stage; callers that read the mesh set `load`.
struct StripeMilliseconds {
  double load = 0;
  double topology = 0;   ///< neighbourhood and normals, colours, aggregates: once per connectivity
  double frequency = 0;  ///< solving for frequencies
  double couple = 0;     ///< phase shifts
  double solve = 0;
  double pattern = 0;  ///< corner phases and quality
  double cancel = 0;   ///< `cancel_branches`, if requested
};

/// A pattern with its input and metrics.
struct StripePattern {
  WaveSet waves;                      ///< with the chosen frequencies
  FrequencyField frequencies_wanted;  ///< requested; empty without slack: those of `waves`
  std::optional<FrequencyChange> frequency_change;  ///< with slack
  PhaseShiftKind phase_shift = PhaseShiftKind::aligned;
  PhaseSolution solution;             ///< `solution.z`: one phase per vertex
  std::vector<CornerPhases> corners;  ///< one entry per triangle
  PatternQuality quality;
  StripeMilliseconds milliseconds;
};

/// Solves for frequencies if the options have slack, couples the waves along the edges of the
/// surface, solves for phases, lifts them to the corners of the triangles and measures the result;
/// points without triangles are measured as in `measure_point_quality`. `waves` has one entry per
/// vertex. Throws Error for waves that are not valid (`WaveSet`); for directions that are not
/// tangent (one more than 60 degrees out of its plane, or more than a tenth more than 10); for
/// waves with less than 1e-4 edges per period at half of the vertices, or 1e-6 at any; for last or
/// fixed phases that `anchor_phases` or the solver rejects; and what `solve_phases` throws.
/// `pattern_warnings` lists likely mistakes.
StripePattern stripe_pattern(const Surface& surface, WaveSet waves,
                             const StripeOptions& options = {}, const Progress& progress = {});

/// As above along a direction field; `frequency`, or each vertex's entry of `frequencies`, is in
/// stripes per unit length. Stripes run across the directions.
StripePattern stripe_pattern(const Surface& surface, DirectionField field, float frequency,
                             const StripeOptions& options = {}, const Progress& progress = {});
StripePattern stripe_pattern(const Surface& surface, DirectionField field,
                             FrequencyField frequencies, const StripeOptions& options = {},
                             const Progress& progress = {});

/// Recomputes `corners` and `quality`, including errors against the requested frequencies, from the
/// rest of the pattern, such as one solved elsewhere. `branch_penalty` is Slack::branch_penalty.
void measure_pattern(const Surface& surface, std::span<const float> branch_penalty,
                     StripePattern& pattern, const Progress& progress = {});

/// The centre lines of the pattern's stripes, sin Phi = 1, over its whole surface. At high
/// frequencies several cross a triangle. Curves do not cross; each is closed, or both its ends have
/// a reason (CurveEnd). Waves run to the left of curves, seen from outside, where the field and the
/// surface can be oriented. Throws Error for a pattern of another surface, and on points without
/// triangles; Cancelled if `progress` cancels.
StripeCurves stripe_curves(const Surface& surface, const StripePattern& pattern,
                           const CurveOptions& options = {}, const Progress& progress = {});

/// Fabrication measures of curves that `stripe_curves` traced from this pattern: lengths, gaps and,
/// for a `path_width` above 0 (units of length), coverage. Throws Error as `stripe_curves` does,
/// and for a width below 0 or not finite; Cancelled if `progress` cancels.
CurveMeasures measure_curves(const Surface& surface, const StripePattern& pattern,
                             const StripeCurves& curves, double path_width = 0,
                             const Progress& progress = {});

/// Points where the stripes of two patterns on one surface cross, with or without triangles. Of
/// points nearer to each other than a quarter of their spacing only one is kept. Throws Error for
/// patterns of another surface, and in a build without nanoflann; Cancelled if `progress` cancels.
std::vector<Sample> stripe_samples(const Surface& surface, const StripePattern& u,
                                   const StripePattern& v, const Progress& progress = {});

/// Validates the waves of textures and crosses. Throws Error unless `waves` has one entry for each
/// of the surface's vertices, for waves that are not valid (`WaveSet`), and for a direction more
/// than 4 degrees out of the tangent plane, which a quarter turn about the normal would shorten.
void check_tangent_waves(const Surface& surface, const WaveSet& waves);

/// As above for vertices with these normals.
void check_tangent_waves(std::span<const Vec3> normals, const WaveSet& waves);

}  // namespace brindle
