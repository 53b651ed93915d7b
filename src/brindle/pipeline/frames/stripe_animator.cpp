#include "brindle/stripe_animator.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "brindle/base/standard.h"
#include "brindle/base/stopwatch.h"
#include "brindle/error.h"
#include "brindle/phases/hierarchy.h"
#include "brindle/phases/multilevel.h"
#include "brindle/phases/sliced_waves.h"
#include "brindle/pipeline/frames/frame_check.h"
#include "brindle/pipeline/frames/last_phases.h"
#include "brindle/pipeline/frames/yielding_frames.h"
#include "brindle/solver.h"
#include "brindle/waves/wave_check.h"

namespace brindle {

struct StripeAnimator::State {
  std::shared_ptr<const Adjacency> neighborhood;
  AnimatorOptions options;
  double topology_milliseconds = 0;

  Hierarchy hierarchy;            ///< empty before the first frame
  bool has_frame = false;         ///< whether a frame has come to its end
  bool is_sibling = false;        ///< whether the hierarchy was there before
  std::vector<SlicedWave> waves;  ///< of the last frame
  /// Of the frame that is solved, if it may be taken back. One that nobody listens to need not,
  /// where nothing comes after it, and its waves replace the last ones at once: that saves memory.
  std::vector<SlicedWave> cancellable_waves;
  bool may_be_taken_back = false;
  bool has_yielded = false;      ///< whether frequencies of the frame that is solved are new
  std::vector<float> weights;    ///< options.edge_weights by entry
  std::vector<float> degree;     ///< sum of weights by slot
  std::vector<Complex> last_z;   ///< by slot; empty: none
  std::vector<Complex> given_z;  ///< by vertex: what the next frame follows instead; empty: none
  std::vector<Complex> z_by_vertex;
  Momentum momentum;
  std::vector<Complex> last_momentum;  ///< before the frame that is solved, if it has changed
  bool has_iterated = false;           ///< whether it has
  YieldingFrames yielding;
  NormalsInPlace in_place;

  Level& finest() { return hierarchy.levels[0]; }
  std::vector<SlicedWave>& next_waves() { return may_be_taken_back ? cancellable_waves : waves; }
  bool has_last() const { return !last_z.empty(); }
  bool has_given() const { return !given_z.empty(); }
  /// Whether the next frame is a descent, not the paper's iterations.
  bool descends() const { return options.solver == FrameSolver::multilevel || !has_last(); }
};

namespace {

FrameResult unchanged_result() {
  FrameResult result;
  result.unchanged = true;
  return result;
}

/// A frame that nobody listens to allocates nothing.
Progress progress_of_frame(const Progress& progress) {
  return progress.is_heard() ? JobStages(progress, {{"frame", 1}}).begin("frame") : Progress();
}

}  // namespace

StripeAnimator::StripeAnimator(std::shared_ptr<const Adjacency> neighborhood,
                               const AnimatorOptions& options)
    : state_(std::make_unique<State>()) {
  check_animator_options(options);
  refuse_slack(options);
  if (!neighborhood)
    throw Error("animator: the surface has no neighbours; make_surface finds them");
  if (options.phase_shift == PhaseShiftKind::common_source) {
    throw Error("animator options: the phase shift must be aligned or trapezoid");
  }
  if (!options.edge_weights.empty() &&
      options.edge_weights.size() != neighborhood->neighbors.size()) {
    throw Error("animator options: there must be one edge weight per directed edge");
  }
  check_edge_weights(options.edge_weights);
  state_->neighborhood = std::move(neighborhood);
  state_->options = options;
  state_->momentum.strength = SolverOptions().momentum;
}

StripeAnimator::StripeAnimator(const Surface& surface, const AnimatorOptions& options)
    : StripeAnimator(surface.neighborhood, without_slack(options)) {
  state_->yielding = YieldingFrames(surface, options.slack);
  state_->options.slack = options.slack;
  state_->in_place = {surface.mesh.positions, surface.normals};
}

StripeAnimator::StripeAnimator(std::unique_ptr<State> state) : state_(std::move(state)) {}
StripeAnimator::~StripeAnimator() = default;
StripeAnimator::StripeAnimator(StripeAnimator&&) noexcept = default;
StripeAnimator& StripeAnimator::operator=(StripeAnimator&&) noexcept = default;

FrameResult StripeAnimator::frame(const FrameInput& input, const Progress& progress) {
  FrameResult result = solve(input, progress);
  keep(input, result);
  return result;
}

/// Lets frames be taken back that have been solved, from the next one on.
void StripeAnimator::allow_take_back() { state_->may_be_taken_back = true; }

/// The next frame, which `keep` or `take_back` must follow: until then, its phases are not the
/// animator's, and not in the result.
FrameResult StripeAnimator::solve(const FrameInput& input, const Progress& heard) {
  State& s = *state_;
  check_frame_input(input, s.neighborhood->node_count());
  check_values(input, *s.neighborhood, s.in_place);
  // Who hears of progress can cancel, whatever the frame does.
  if (heard.is_heard()) allow_take_back();
  s.has_yielded = s.has_iterated = false;
  if (!s.has_given() && s.has_last() && s.yielding.is_kept(input)) return unchanged_result();
  Stopwatch watch;
  const Progress progress = progress_of_frame(heard);
  const FrameInput yielded = s.yielding.yielded(input, progress.part(0, 0.3));
  s.has_yielded = true;
  const double yield_milliseconds = watch.lap();
  progress.report(0.3);
  start(progress.part(0.3, 0.4));
  progress.report(0.4);
  watch.lap();
  // Given phases are of this frame's directions: there is nothing to turn.
  const bool changed =
      load_waves(s.finest().layout(), yielded.positions, yielded.directions, yielded.frequencies,
                 s.next_waves(), s.waves,
                 s.has_given() ? std::span<Complex>() : std::span(s.last_z), s.momentum.m);
  if (s.has_given()) {
    take_given();
  } else if (s.has_last() && !changed) {
    return unchanged_result();
  }
  FrameResult result;
  try {
    result.milliseconds = solve_next(watch, progress.part(0.4, 1));
  } catch (...) {
    take_phases_back();
    throw;
  }
  if (s.has_last()) result.phase_step = phase_steps(s.finest().z, s.last_z, s.degree).mean();
  result.milliseconds.solve = watch.lap();
  result.milliseconds.frequency = yield_milliseconds;
  return result;
}

/// Makes the frame that was just solved the last one. Cannot fail.
void StripeAnimator::keep(const FrameInput& input, FrameResult& solved) {
  State& s = *state_;
  Stopwatch watch;
  if (!solved.unchanged) keep_phases();
  if (s.has_yielded) s.yielding.keep(input);
  solved.z = s.z_by_vertex;
  solved.frequencies = s.yielding.frequencies();
  solved.frequency_change = s.yielding.change();
  if (!solved.unchanged) solved.milliseconds.solve += watch.lap();
}

/// Makes everything as it was before the frame that was just solved. Cannot fail.
void StripeAnimator::take_back(const FrameResult& solved) {
  if (!solved.unchanged) take_phases_back();
}

/// The finest level, and everything that frames write to, so that they allocate nothing.
void StripeAnimator::start(const Progress& progress) {
  State& s = *state_;
  if (!s.degree.empty()) return;
  Stopwatch watch;
  const bool builds = s.hierarchy.levels.empty();
  if (builds) s.hierarchy = finest_level(*s.neighborhood, progress);
  const SlicedLayout& layout = s.finest().layout();
  s.waves.reserve(layout.slot_count());
  if (s.may_be_taken_back) s.cancellable_waves.reserve(layout.slot_count());
  s.last_z.resize(layout.slot_count());  // so that no page is new when phases are kept
  s.last_z.clear();
  s.z_by_vertex.resize(layout.slot_of.size());
  if (!s.options.edge_weights.empty()) {
    s.weights = sliced_weights(layout, *s.neighborhood, s.options.edge_weights);
  }
  if (s.options.solver == FrameSolver::relaxation) s.momentum.m.resize(layout.slot_count());
  s.degree.resize(layout.slot_count());
  if (builds) s.topology_milliseconds = watch.lap();
}

/// Makes given phases the last ones.
void StripeAnimator::take_given() {
  State& s = *state_;
  const SlicedLayout& layout = s.finest().layout();
  s.last_z.assign(layout.slot_count(), Complex(0));
  to_slots(layout, s.given_z, s.last_z);
}

/// From the next waves to phases of the finest level.
FrameMilliseconds StripeAnimator::solve_next(Stopwatch& watch, const Progress& progress) {
  State& s = *state_;
  FrameMilliseconds milliseconds;
  progress.report(0);
  couple_next();
  milliseconds.couple = watch.lap();
  progress.report(0);
  const bool builds = s.hierarchy.levels.size() == 1;
  if (builds) {
    coarsen(s.hierarchy, progress.part(0, 0.6));
    s.topology_milliseconds += watch.lap();
  }
  if (!s.has_last() && s.options.lambda > 0) {
    for (Level& level : s.hierarchy.levels) {
      level.couplings.anchor.reserve(level.layout().slot_count());
    }
  }
  if (s.descends() && !builds) renew(s.hierarchy);
  milliseconds.sum = watch.lap();
  if (s.descends()) {
    const SweepPlan plan =
        builds ? SweepPlan::for_new_levels(s.options.sweeps, s.finest().layout().slot_count())
               : s.options.sweeps;
    descend(s.hierarchy, plan, progress.part(0.6, 0.7));
    run_cycles(s.hierarchy, plan, s.options.cycles, progress.part(0.7, 1));
  } else {
    iterate();
  }
  return milliseconds;
}

void StripeAnimator::couple_next() {
  State& s = *state_;
  Level& finest = s.finest();
  couple(finest.layout(), s.next_waves(), s.options.phase_shift, s.weights, finest.couplings,
         s.degree);
  const bool anchored =
      s.has_last() && s.options.lambda > 0 && s.options.solver == FrameSolver::multilevel;
  if (anchored) {
    set_anchors(s.degree, s.last_z, s.options.lambda, finest.couplings.anchor);
  } else {
    finest.couplings.anchor.clear();
  }
}

/// The paper's iterations from the last phases, and from the peak where none is known.
void StripeAnimator::iterate() {
  State& s = *state_;
  Level& finest = s.finest();
  if (s.may_be_taken_back) {
    s.last_momentum = s.momentum.m;
    s.has_iterated = true;
  }
  ranges::transform(s.last_z, finest.z.begin(),
                    [](const Complex& z) { return z == Complex(0) ? kPeak : z; });
  for (int iteration = 0; iteration < s.options.iterations; ++iteration) {
    for (Index color = 0; color < finest.layout().color_count(); ++color) {
      relax_color(finest.layout(), finest.couplings, finest.z, s.momentum, color);
    }
  }
}

/// Makes the frame just solved the last one. Cannot fail.
void StripeAnimator::keep_phases() {
  State& s = *state_;
  const SlicedLayout& layout = s.finest().layout();
  s.last_z.assign(s.finest().z.begin(), s.finest().z.begin() + layout.slot_count());
  to_nodes(layout, s.last_z, s.z_by_vertex);
  s.given_z.clear();
  if (s.may_be_taken_back) std::swap(s.waves, s.cancellable_waves);
  s.has_frame = true;
}

/// Makes everything as it was before a frame that has not come to its end.
void StripeAnimator::take_phases_back() {
  State& s = *state_;
  if (s.has_iterated) std::swap(s.momentum.m, s.last_momentum);
  if (s.has_frame) {
    Level& finest = s.finest();
    turn_phases(s.waves, s.next_waves(), s.last_z);
    turn_phases(s.waves, s.next_waves(), s.momentum.m);
    couple(finest.layout(), s.waves, s.options.phase_shift, s.weights, finest.couplings, s.degree);
    to_slots(finest.layout(), s.z_by_vertex, finest.z);
  } else if (!s.is_sibling) {
    // Aggregates follow the couplings of the first frame that comes to its end.
    s.hierarchy = {};
    s.degree.clear();
  }
}

double StripeAnimator::energy() const {
  if (!state_->has_frame) throw Error("animator: there is no energy before the first frame");
  const Level& finest = state_->finest();
  return brindle::energy(finest.layout(), finest.couplings, finest.z);
}

StripeAnimator StripeAnimator::sibling() const {
  auto state = std::make_unique<State>();
  state->neighborhood = state_->neighborhood;
  state->options = state_->options;
  state->hierarchy = brindle::sibling(state_->hierarchy);
  state->is_sibling = !state->hierarchy.levels.empty();
  state->may_be_taken_back = state_->may_be_taken_back;
  state->momentum.strength = state_->momentum.strength;
  state->yielding = state_->yielding.sibling();
  state->in_place = state_->in_place;
  return StripeAnimator(std::move(state));
}

void StripeAnimator::set_last_phases(std::span<const Complex> z) {
  check_last_phases(z, state_->neighborhood->node_count());
  state_->given_z.assign(z.begin(), z.end());
}

void StripeAnimator::restart() {
  state_->last_z.clear();
  state_->given_z.clear();
  state_->yielding.restart();
  ranges::fill(state_->momentum.m, Complex(0));
}

void StripeAnimator::set_slack(const Slack& slack) {
  state_->yielding.set_slack(slack);
  state_->options.slack = slack;
}

double StripeAnimator::topology_milliseconds() const { return state_->topology_milliseconds; }

}  // namespace brindle
