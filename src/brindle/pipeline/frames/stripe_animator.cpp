#include "brindle/stripe_animator.h"

#include <utility>

#include "brindle/base/standard.h"
#include "brindle/base/stopwatch.h"
#include "brindle/error.h"
#include "brindle/phases/hierarchy.h"
#include "brindle/phases/multilevel.h"
#include "brindle/phases/sliced_waves.h"
#include "brindle/pipeline/frames/animator_archive.h"
#include "brindle/pipeline/frames/frame_input.h"
#include "brindle/pipeline/frames/frame_phases.h"
#include "brindle/waves/wave_check.h"

namespace brindle {

struct StripeAnimator::State {
  std::shared_ptr<const Adjacency> neighborhood;
  AnimatorOptions options;

  Hierarchy hierarchy = {};  ///< empty before the first frame
  /// The waves by slot whose couplings the levels follow; null before these.
  std::shared_ptr<const std::vector<SlicedWave>> built_from = {};
  bool is_sibling = false;  ///< whether the hierarchy came from another animator
  FramePhases phases = FramePhases(options);
  bool has_relaxed = false;    ///< whether the frame being solved has relaxed frequencies
  bool has_coarsened = false;  ///< whether the frame being solved builds coarser levels
  RelaxedFrequencySolver relaxed = {};
  RestNormals in_place = {};
  FrameSewing sewing = {};

  Level& finest() { return hierarchy.levels[0]; }
  void build_levels(std::vector<SlicedWave> waves);
  void drop_levels();
};

/// Builds the levels that follow the couplings of these waves.
void StripeAnimator::State::build_levels(std::vector<SlicedWave> waves) {
  built_from = std::make_shared<const std::vector<SlicedWave>>(std::move(waves));
  phases.couple_to(finest(), *built_from);
  finest().couplings.anchor.clear();
  coarsen(hierarchy);
}

/// Leaves a new finest level alone; the old one has gauges.
void StripeAnimator::State::drop_levels() {
  Level made = make_level({finest().topology.layout, nullptr});
  hierarchy = {};
  hierarchy.levels.push_back(std::move(made));
  built_from.reset();
}

namespace {

/// The levels of one process, with the functions of a RankHierarchy.
struct WholeLevels {
  Hierarchy& hierarchy;
  const std::vector<SlicedWave>& waves;  ///< of the finest level's couplings
  std::shared_ptr<const std::vector<SlicedWave>>& built_from;

  Level& finest() { return hierarchy.levels[0]; }
  Index slots_of_all() { return finest().layout().slot_count(); }
  bool is_coarsened() const { return hierarchy.levels.size() > 1; }
  void coarsen(const Progress& progress) {
    brindle::coarsen(hierarchy, progress);
    if (is_coarsened()) built_from = std::make_shared<const std::vector<SlicedWave>>(waves);
  }
  void renew() { brindle::renew(hierarchy); }
  void descend(SweepPlan plan, const Progress& progress) {
    brindle::descend(hierarchy, plan, progress);
  }
  void run_cycles(SweepPlan plan, int cycles, const Progress& progress) {
    brindle::run_cycles(hierarchy, plan, cycles, progress);
  }
  void relax(Momentum& momentum) {
    Level& level = finest();
    for (Index color = 0; color < level.layout().color_count(); ++color) {
      relax_color(level.layout(), level.couplings, level.z, momentum, color);
    }
  }
};

/// For the next frames, so that they allocate nothing.
void reserve_anchors(Hierarchy& hierarchy) {
  for (Level& level : hierarchy.levels) {
    level.couplings.anchor.reserve(level.layout().slot_count());
  }
}

FrameResult unchanged_result() {
  FrameResult result;
  result.unchanged = true;
  return result;
}

/// Without a listener, a frame allocates nothing.
Progress progress_of_frame(const Progress& progress) {
  return progress.is_heard() ? JobStages(progress, {{"frame", 1}}).begin("frame") : Progress();
}

void check_options(const std::shared_ptr<const Adjacency>& neighborhood,
                   const AnimatorOptions& options) {
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
}

}  // namespace

StripeAnimator::StripeAnimator(std::shared_ptr<const Adjacency> neighborhood,
                               const AnimatorOptions& options) {
  check_options(neighborhood, options);
  state_ = std::make_unique<State>(State{neighborhood, options});
}

StripeAnimator::StripeAnimator(const Surface& surface, const AnimatorOptions& options)
    : StripeAnimator(surface.neighborhood, without_slack(options)) {
  state_->sewing = FrameSewing(surface);
  state_->relaxed = frame_relaxation(surface, options.slack);
  state_->options.slack = options.slack;
  state_->in_place = {surface.mesh.positions, surface.normals};
}

StripeAnimator::StripeAnimator(std::unique_ptr<State> state) : state_(std::move(state)) {}
StripeAnimator::~StripeAnimator() = default;
StripeAnimator::StripeAnimator(StripeAnimator&&) noexcept = default;
StripeAnimator& StripeAnimator::operator=(StripeAnimator&&) noexcept = default;

FrameResult StripeAnimator::frame(const FrameInput& input, const Progress& progress) {
  check_frame_input(input, state_->neighborhood->node_count());
  check_values(input, *state_->neighborhood, state_->in_place);
  FrameResult result = solve(input, progress);
  keep(input, result);
  return result;
}

/// Makes frames reversible, starting with the next one.
void StripeAnimator::allow_take_back() { state_->phases.may_be_taken_back = true; }

/// Solves the next frame for checked input. `keep` or `take_back` must follow; until then neither
/// the animator nor the result has its phases.
FrameResult StripeAnimator::solve(const FrameInput& input, const Progress& heard) {
  State& s = *state_;
  // A listener may cancel the frame.
  if (heard.is_heard()) allow_take_back();
  s.has_relaxed = false;
  const bool follows = s.phases.has_last && !s.phases.has_given;
  if (follows && s.relaxed.is_kept(relaxation_of(input))) return unchanged_result();
  FrameClock clock;
  const Progress progress = progress_of_frame(heard);
  const FrameInput relaxed = relaxed_input(s.relaxed, input, progress.part(0, 0.3));
  s.has_relaxed = true;
  progress.report(0.3);
  clock.add(&FrameMilliseconds::frequency);
  start(progress.part(0.3, 0.4));
  clock.lap();
  s.has_coarsened = s.hierarchy.levels.size() == 1;
  if (!s.phases.load(s.finest(), relaxed)) return unchanged_result();
  try {
    WholeLevels levels{s.hierarchy, s.phases.next_waves(), s.built_from};
    s.phases.solve(levels, s.options, clock, progress.part(0.4, 1));
    if (!s.phases.has_last && s.options.lambda > 0) reserve_anchors(s.hierarchy);
    if (s.sewing.has_creases() && s.phases.starts_afresh()) sew(relaxed);
  } catch (...) {
    take_phases_back();
    throw;
  }
  FrameResult result;
  result.phase_step = s.phases.steps(s.finest()).mean();
  clock.add(&FrameMilliseconds::solve);
  result.milliseconds = clock.spent;
  return result;
}

/// Aligns stripes across creases; frames that follow stay aligned.
void StripeAnimator::sew(const FrameInput& input) {
  State& s = *state_;
  std::vector<Complex> z = to_nodes(s.finest().layout(), s.finest().z);
  s.sewing.sew(input, z);
  to_slots(s.finest().layout(), z, s.finest().z);
}

/// Commits the frame that was solved last. Does not throw.
void StripeAnimator::keep(const FrameInput& input, FrameResult& solved) {
  State& s = *state_;
  Stopwatch watch;
  if (!solved.unchanged) s.phases.keep(s.finest());
  if (s.has_relaxed) s.relaxed.keep(relaxation_of(input));
  solved.z = s.phases.z_by_node;
  solved.frequencies = s.relaxed.frequencies();
  solved.frequency_change = s.relaxed.kept_change();
  if (!solved.unchanged) solved.milliseconds.solve += watch.lap();
}

/// Rolls back the frame that was solved last. Does not throw.
void StripeAnimator::take_back(const FrameResult& solved) {
  if (!solved.unchanged) take_phases_back();
}

/// Builds the finest level and all buffers.
void StripeAnimator::start(const Progress& progress) {
  State& s = *state_;
  FramePhases& phases = s.phases;
  if (!phases.degree.empty()) return;
  Stopwatch watch;
  const bool builds = s.hierarchy.levels.empty();
  if (builds) s.hierarchy = finest_level(*s.neighborhood, progress);
  const SlicedLayout& layout = s.finest().layout();
  phases.start(layout);
  if (!s.options.edge_weights.empty()) {
    phases.weights = sliced_weights(layout, *s.neighborhood, s.options.edge_weights);
  }
  if (builds) phases.topology_milliseconds = watch.lap();
}

/// Rolls back a frame that was not completed.
void StripeAnimator::take_phases_back() {
  State& s = *state_;
  // Aggregates depend on the couplings of the first completed frame with waves.
  if (s.has_coarsened) s.drop_levels();
  s.phases.take_back(s.finest());
  if (s.phases.has_frame || s.is_sibling) return;
  s.hierarchy = {};
  s.phases.degree.clear();
}

double StripeAnimator::energy() const {
  if (!state_->phases.has_frame) throw Error("animator: there is no energy before the first frame");
  const Level& finest = state_->finest();
  return brindle::energy(finest.layout(), finest.couplings, finest.z);
}

StripeAnimator StripeAnimator::sibling() const {
  auto state = std::make_unique<State>(State{state_->neighborhood, state_->options});
  state->hierarchy = brindle::sibling(state_->hierarchy);
  state->built_from = state_->built_from;
  state->is_sibling = !state->hierarchy.levels.empty();
  state->phases.may_be_taken_back = state_->phases.may_be_taken_back;
  state->relaxed = state_->relaxed.sibling();
  state->in_place = state_->in_place;
  state->sewing = state_->sewing;
  return StripeAnimator(std::move(state));
}

void StripeAnimator::set_last_phases(std::span<const Complex> z) {
  check_last_phases(z, state_->neighborhood->node_count());
  state_->phases.give(z);
}

void StripeAnimator::restart() {
  state_->phases.restart();
  state_->relaxed.restart();
}

void StripeAnimator::set_slack(const Slack& slack) {
  check_made_with_slack(state_->relaxed.relaxes());
  state_->relaxed.set_slack(slack);
  state_->options.slack = slack;
}

double StripeAnimator::topology_milliseconds() const {
  return state_->phases.topology_milliseconds;
}

void archive_options(Archive& archive, AnimatorOptions& options) {
  archive.choice(options.solver, FrameSolver::relaxation);
  archive(options.lambda, options.sweeps, options.cycles, options.iterations);
  archive.choice(options.phase_shift, PhaseShiftKind::trapezoid);
  archive(options.edge_weights, options.slack.everywhere, options.slack.by_vertex,
          options.slack.branch_penalty);
}

void check_made_of(const Surface& surface, const Adjacency& neighborhood,
                   std::span<const Vec3> normals) {
  if (ranges::equal(neighborhood.offsets, surface.neighborhood->offsets) &&
      ranges::equal(neighborhood.neighbors, surface.neighborhood->neighbors) &&
      ranges::equal(normals, surface.normals)) {
    return;
  }
  throw Error("the animator was made of another surface; save it with its own");
}

AnimatorOptions made_with(AnimatorOptions options, bool slack) {
  if (slack) options.slack = 1;
  return options;
}

bool AnimatorArchive::has_slack(const StripeAnimator& animator) {
  return animator.state_->relaxed.relaxes();
}

void AnimatorArchive::state(Archive& archive, StripeAnimator& animator) {
  StripeAnimator::State& s = *animator.state_;
  bool built = s.built_from != nullptr, started = built || s.phases.has_frame;
  archive(built, started);
  if (built && !started) Archive::fail();
  if (archive.reads() && started) animator.start({});
  if (built) {
    std::vector<SlicedWave> waves;
    if (!archive.reads()) waves = *s.built_from;
    archive_waves(archive, s.finest().layout(), waves);
    // A sibling shares the levels.
    if (archive.reads() && !s.built_from) s.build_levels(std::move(waves));
  }
  s.phases.archive(archive, s.neighborhood->node_count(), started ? &s.finest() : nullptr);
  s.relaxed.archive(archive);
}

void AnimatorArchive::write(Archive& archive, const Surface& surface, StripeAnimator& animator) {
  StripeAnimator::State& s = *animator.state_;
  bool of_surface = !s.in_place.normals.empty(), slack = has_slack(animator);
  check_made_of(surface, *s.neighborhood, of_surface ? s.in_place.normals : surface.normals);
  archive(of_surface, slack);
  archive_options(archive, s.options);
  state(archive, animator);
}

StripeAnimator AnimatorArchive::read_stripes(Archive& archive, const Surface& surface) {
  bool of_surface = true, slack = false;
  AnimatorOptions options;
  archive(of_surface, slack);
  archive_options(archive, options);
  StripeAnimator animator = of_surface ? StripeAnimator(surface, made_with(options, slack))
                                       : StripeAnimator(surface.neighborhood, options);
  if (slack) animator.set_slack(options.slack);
  state(archive, animator);
  return animator;
}

}  // namespace brindle
