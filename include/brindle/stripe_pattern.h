/// The main job: from a surface with waves to a measured stripe pattern.
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
#include "brindle/surface.h"
#include "brindle/yielding_frequency.h"

namespace BRINDLE_EXPORT brindle {

/// What multiplies the paper's weight |<d_i, d_j>| of an edge.
enum class EdgeWeights {
  paper,     ///< nothing
  cotangent  ///< `cotangent_weights`: lower angle errors for a longer coupling stage
};

/// Turns a phase graph into phases, as `solve_phases` and `GpuSolver::solve` of brindle/gpu do.
using SolvePhases = std::function<PhaseSolution(const PhaseGraph&, const SolverOptions&,
                                                const Progress&, const SolverData&)>;

struct StripeOptions {
  PhaseShiftKind phase_shift = PhaseShiftKind::aligned;
  EdgeWeights weights = EdgeWeights::paper;
  SolverOptions solver;
  SolvePhases solve;  ///< empty: on the processor
  /// Phases to stay near to: a unit number per vertex, 0 where none is known, as `matched_phases`
  /// and `carried_phases` give them; empty for none. For Solver::multilevel.
  std::vector<Complex> last_phases;
  float lambda = 0.025f;  ///< how near, as AnimatorOptions has it; 0: no matter
  Slack slack = 0;        ///< how far frequencies may depart from those of the waves, so that fewer
                          ///< stripes begin or end (yielding_frequency.h); 0: not at all
  /// Phases that are given: a unit number per vertex, 0 where there is none, as `boundary_phases`
  /// makes them; empty for none. They are those of the result. For Solver::multilevel.
  std::vector<Complex> fixed_phases;
};

/// Wall-clock milliseconds a stage; `load` is left to whoever reads the mesh.
struct StripeMilliseconds {
  double load = 0;
  double topology = 0;   ///< neighbourhood and normals, colours, aggregates: once per connectivity
  double frequency = 0;  ///< frequencies that yield
  double couple = 0;     ///< phase shifts
  double solve = 0;
  double pattern = 0;  ///< corner phases and quality
  double merge = 0;    ///< `merge_branches`, if it was asked for
};

/// A pattern and all that it was made with.
struct StripePattern {
  WaveSet waves;                      ///< with the frequencies chosen
  FrequencyField frequencies_wanted;  ///< those asked for; empty without slack: the same
  std::optional<FrequencyChange> frequency_change;  ///< with slack
  PhaseShiftKind phase_shift = PhaseShiftKind::aligned;
  PhaseSolution solution;             ///< `solution.z`: one phase per vertex
  std::vector<CornerPhases> corners;  ///< one entry per triangle
  PatternQuality quality;
  StripeMilliseconds milliseconds;
};

/// Lets frequencies yield where the options have slack, couples the waves along the edges of the
/// surface, solves for phases, lifts them to the corners of the triangles and measures the result;
/// on points without triangles as `measure_point_quality` does. `waves` has one entry per vertex.
/// Throws Error for waves that are not valid (`WaveSet`), for directions that are not tangent (one
/// more than 60 degrees out of its plane, or more than a tenth more than 10), for waves that pass
/// less than a 10,000th of an edge a period at half of the vertices or a millionth at any, for last
/// or fixed phases that `anchor_phases` refuses or another solver than multilevel has, and what
/// `solve_phases` throws. `pattern_warnings` says what is probably not meant.
StripePattern stripe_pattern(const Surface& surface, WaveSet waves,
                             const StripeOptions& options = {}, const Progress& progress = {});

/// The same along a direction field, with as many stripes per unit length as `frequency` says, or
/// as each vertex's entry of `frequencies` does. Stripes run across the directions.
StripePattern stripe_pattern(const Surface& surface, DirectionField field, float frequency,
                             const StripeOptions& options = {}, const Progress& progress = {});
StripePattern stripe_pattern(const Surface& surface, DirectionField field,
                             FrequencyField frequencies, const StripeOptions& options = {},
                             const Progress& progress = {});

/// Renews `corners` and `quality`, the latter also against the frequencies asked for, from the
/// other parts of the pattern: of one whose phases were found elsewhere. `calm` is that of a Slack.
void measure_pattern(const Surface& surface, std::span<const float> calm, StripePattern& pattern,
                     const Progress& progress = {});

/// The centre lines of the pattern's stripes, sin Phi = 1, over the whole surface that it was made
/// for. Several cross a triangle where the frequency asks for it. Curves do not cross; each is
/// closed, or both its ends have one of the reasons of CurveEnd. They run so that waves run to
/// their left, seen from outside, where the field and the surface can be oriented. Throws Error for
/// a pattern of another surface, and on points without triangles; Cancelled if `progress` asks for
/// it.
StripeCurves stripe_curves(const Surface& surface, const StripePattern& pattern,
                           const CurveOptions& options = {}, const Progress& progress = {});

/// What a maker asks of curves that `stripe_curves` has traced of this pattern: lengths, gaps and,
/// for a `line_width` above 0 (units of length), coverage. Throws Error as `stripe_curves` does,
/// and for a width below 0 or not finite; Cancelled if `progress` asks for it.
CurveMeasures measure_curves(const Surface& surface, const StripePattern& pattern,
                             const StripeCurves& curves, double line_width = 0,
                             const Progress& progress = {});

/// Points where the stripes of two patterns on one surface cross, or of points without triangles;
/// of those nearer to each other than a quarter of their spacing only one. Throws Error for
/// patterns of another surface, and in a build without nanoflann; Cancelled if `progress` asks for
/// it.
std::vector<Sample> stripe_samples(const Surface& surface, const StripePattern& u,
                                   const StripePattern& v, const Progress& progress = {});

/// What textures and crosses ask of waves: throws Error unless `waves` has one entry for each of
/// the surface's vertices, for waves that are not valid (`WaveSet`), and for a
/// direction that sticks out of the tangent plane by more than 4 degrees: a quarter turn about the
/// normal would not leave it as long as it is.
void check_tangent_waves(const Surface& surface, const WaveSet& waves);

/// The same for vertices with these normals.
void check_tangent_waves(std::span<const Vec3> normals, const WaveSet& waves);

}  // namespace brindle
