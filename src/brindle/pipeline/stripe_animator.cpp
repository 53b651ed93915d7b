#include "brindle/pipeline/stripe_animator.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "brindle/error.h"
#include "brindle/base/parallel.h"
#include "brindle/base/stopwatch.h"
#include "brindle/phases/hierarchy.h"
#include "brindle/phases/multilevel.h"
#include "brindle/phases/sliced_waves.h"
#include "brindle/phases/solver.h"

namespace brindle {

struct StripeAnimator::State {
  std::shared_ptr<const Adjacency> neighborhood;
  AnimatorOptions options;
  double topology_milliseconds = 0;

  Hierarchy hierarchy;            ///< empty before the first frame
  std::vector<SlicedWave> waves;  ///< of the last frame
  std::vector<float> weights;     ///< options.edge_weights by entry
  std::vector<float> degree;      ///< sum of weights by slot
  std::vector<Complex> last_z;    ///< by slot; empty: none
  std::vector<Complex> z_by_vertex;
  Momentum momentum;

  Level& finest() { return hierarchy.levels[0]; }
};

namespace {

/// T_i = lambda deg_i z_i of the last frame.
void set_anchors(std::span<const float> degree, std::span<const Complex> last_z, float lambda,
                 std::vector<Complex>& anchor) {
  anchor.resize(degree.size());
  parallel_for(degree.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t slot = begin; slot < end; ++slot) {
      anchor[slot] = lambda * degree[slot] * last_z[slot];
    }
  });
}

/// The mean over slots with a wave of |arg(z conj(last_z))|.
double mean_step(std::span<const Complex> z, std::span<const Complex> last_z,
                 std::span<const float> degree) {
  struct Sum {
    double angle = 0, count = 0;
    Sum operator+(const Sum& other) const { return {angle + other.angle, count + other.count}; }
  };
  const Sum sum = parallel_sum<Sum>(degree.size(), [&](std::size_t begin, std::size_t end) {
    Sum part;
    for (std::size_t slot = begin; slot < end; ++slot) {
      if (degree[slot] <= 0) continue;
      part.angle += std::abs(std::arg(z[slot] * std::conj(last_z[slot])));
      part.count += 1;
    }
    return part;
  });
  return sum.count > 0 ? sum.angle / sum.count : 0;
}

}  // namespace

void check(const AnimatorOptions& options) {
  const auto require = [](bool holds, const char* message) {
    if (!holds) throw Error(std::string("animator options: ") + message);
  };
  require(std::isfinite(options.lambda) && options.lambda >= 0, "lambda must be 0 or above");
  require(options.sweeps >= 0, "sweeps must be 0 or above");
  require(options.cycles >= 0, "cycles must be 0 or above");
  require(options.iterations > 0, "iterations must be above 0");
}

void check(const FrameInput& input, std::size_t vertices) {
  if (input.positions.size() == vertices && input.directions.size() == vertices &&
      input.frequencies.size() == vertices) {
    return;
  }
  throw Error("animator: a frame needs one position, direction and frequency for each of " +
              std::to_string(vertices) + " vertices");
}

StripeAnimator::StripeAnimator(std::shared_ptr<const Adjacency> neighborhood,
                               const AnimatorOptions& options)
    : state_(std::make_unique<State>()) {
  check(options);
  if (options.phase_shift == PhaseShiftKind::common_source) {
    throw Error("animator options: the phase shift must be aligned or trapezoid");
  }
  if (!options.edge_weights.empty() &&
      options.edge_weights.size() != neighborhood->neighbors.size()) {
    throw Error("animator options: there must be one edge weight per directed edge");
  }
  state_->neighborhood = std::move(neighborhood);
  state_->options = options;
  state_->momentum.strength = SolverOptions().momentum;
}

StripeAnimator::StripeAnimator(std::unique_ptr<State> state) : state_(std::move(state)) {}
StripeAnimator::~StripeAnimator() = default;
StripeAnimator::StripeAnimator(StripeAnimator&&) noexcept = default;
StripeAnimator& StripeAnimator::operator=(StripeAnimator&&) noexcept = default;

FrameResult StripeAnimator::frame(const FrameInput& input, const Progress& progress) {
  State& s = *state_;
  check(input, s.neighborhood->node_count());
  Stopwatch watch;
  if (s.hierarchy.levels.empty()) {
    s.hierarchy = finest_level(*s.neighborhood);
    s.topology_milliseconds = watch.lap();
  }
  if (s.degree.empty()) start();
  const bool has_last = !s.last_z.empty();
  const bool changed = load_waves(s.finest().layout(), input.positions, input.directions,
                                  input.frequencies, s.waves, s.last_z);
  FrameResult result;
  if (has_last && !changed) {
    result.z = s.z_by_vertex;
    result.unchanged = true;
    return result;
  }
  couple_frame(has_last);
  result.milliseconds.couple = watch.lap();
  if (s.hierarchy.levels.size() == 1) {
    coarsen(s.hierarchy, progress);
    s.topology_milliseconds += watch.lap();
  }
  if (!has_last && s.options.lambda > 0) {
    for (Level& level : s.hierarchy.levels) {
      level.couplings.anchor.reserve(level.layout().slot_count());
    }
  }
  if (s.options.solver == FrameSolver::multilevel || !has_last) renew(s.hierarchy);
  result.milliseconds.sum = watch.lap();
  solve_frame(has_last, progress);
  const SlicedLayout& layout = s.finest().layout();
  if (has_last) result.phase_step = mean_step(s.finest().z, s.last_z, s.degree);
  s.last_z.assign(s.finest().z.begin(), s.finest().z.begin() + layout.slot_count());
  to_nodes(layout, s.last_z, s.z_by_vertex);
  result.z = s.z_by_vertex;
  result.milliseconds.solve = watch.lap();
  return result;
}

/// Everything that frames write to, so that they allocate nothing.
void StripeAnimator::start() {
  State& s = *state_;
  const SlicedLayout& layout = s.finest().layout();
  s.waves.resize(layout.slot_count());
  s.degree.resize(layout.slot_count());
  s.last_z.resize(layout.slot_count());  // so that no page is new when phases are kept
  s.last_z.clear();
  s.z_by_vertex.resize(layout.slot_of.size());
  if (!s.options.edge_weights.empty()) {
    s.weights = sliced_weights(layout, *s.neighborhood, s.options.edge_weights);
  }
}

void StripeAnimator::couple_frame(bool has_last) {
  State& s = *state_;
  Level& finest = s.finest();
  couple(finest.layout(), s.waves, s.options.phase_shift, s.weights, finest.couplings, s.degree);
  const bool anchored =
      has_last && s.options.lambda > 0 && s.options.solver == FrameSolver::multilevel;
  if (anchored) {
    set_anchors(s.degree, s.last_z, s.options.lambda, finest.couplings.anchor);
  } else {
    finest.couplings.anchor.clear();
  }
}

void StripeAnimator::solve_frame(bool has_last, const Progress& progress) {
  State& s = *state_;
  if (s.options.solver == FrameSolver::multilevel || !has_last) {
    descend(s.hierarchy, s.options.sweeps);
    run_cycles(s.hierarchy, s.options.sweeps, s.options.cycles, progress);
    return;
  }
  Level& finest = s.finest();
  s.momentum.m.resize(finest.layout().slot_count());
  std::ranges::copy(s.last_z, finest.z.begin());
  for (int iteration = 0; iteration < s.options.iterations; ++iteration) {
    for (Index color = 0; color < finest.layout().color_count(); ++color) {
      relax_color(finest.layout(), finest.couplings, finest.z, s.momentum, color);
    }
  }
}

double StripeAnimator::energy() const {
  const Level& finest = state_->finest();
  return brindle::energy(finest.layout(), finest.couplings, finest.z);
}

StripeAnimator StripeAnimator::sibling() const {
  auto state = std::make_unique<State>();
  state->neighborhood = state_->neighborhood;
  state->options = state_->options;
  state->hierarchy = brindle::sibling(state_->hierarchy);
  state->momentum.strength = state_->momentum.strength;
  return StripeAnimator(std::move(state));
}

void StripeAnimator::restart() {
  state_->last_z.clear();
  std::ranges::fill(state_->momentum.m, Complex(0));
}

double StripeAnimator::topology_milliseconds() const { return state_->topology_milliseconds; }

}  // namespace brindle
