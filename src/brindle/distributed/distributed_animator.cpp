#include <algorithm>
#include <optional>
#include <string>
#include <utility>

#include "brindle/base/stopwatch.h"
#include "brindle/distributed/levels/distributed_hierarchy.h"
#include "brindle/distributed/rank_yielding.h"
#include "brindle/distributed/surface/rank_surface.h"
#include "brindle/distributed_stripes.h"
#include "brindle/error.h"
#include "brindle/geometry/measures.h"
#include "brindle/pattern/quality_sums.h"
#include "brindle/phases/multilevel.h"
#include "brindle/phases/sliced_waves.h"
#include "brindle/pipeline/frames/frame_input.h"
#include "brindle/pipeline/frames/frame_phases.h"
#include "brindle/pipeline/measured_pattern.h"
#include "brindle/solver.h"
#include "brindle/waves/fineness.h"
#include "brindle/waves/wave_check.h"

namespace brindle {
namespace {

/// A wave as owners tell others of it.
struct SentWave {
  Vec3 position;
  Vec3 direction;
  float frequency = 1;
};

void check_distributed(const DistributedOptions& options) {
  check_animator_options(options);
  if (options.phase_shift == PhaseShiftKind::common_source) {
    throw Error("animator options: the phase shift must be aligned or trapezoid");
  }
  if (!options.edge_weights.empty()) {
    throw Error("animator options: distributed surfaces have no weights by edge; take `weights`");
  }
}

/// Throws on all ranks what it throws on one. Both must live as long.
Progress on_all(Communicator& ranks, const Progress& progress) {
  return Progress([&ranks, &progress](std::string_view stage, double fraction) {
    ranks.together([&] { progress.report(stage, fraction); });
    return true;
  });
}

}  // namespace

struct DistributedStripeAnimator::State {
  std::shared_ptr<const RankSurface> surface;
  DistributedOptions options;
  double topology_milliseconds = 0;

  std::optional<DistributedHierarchy> hierarchy;  ///< empty before the first frame
  bool has_frame = false;
  int sweeps = 0;         ///< of the last frame, over the finest level
  bool has_last = false;  ///< whether the next frame follows one; a rank may have no vertices
  std::vector<SentWave> sent_waves;  ///< by vertex; of own ones and ghosts
  WaveSet input;                     ///< the same as arrays
  bool has_given = false;            ///< whether the next frame follows phases that were given
  std::vector<Complex> given_z;      ///< these, by own vertex and ghost
  std::vector<SlicedWave> waves, cancellable_waves;  ///< as a StripeAnimator has them
  std::vector<float> weights;                        ///< by entry; empty: 1
  std::vector<float> degree;
  std::vector<Complex> last_z;  ///< by slot
  std::vector<Complex> z_by_node;
  std::vector<Complex> z_by_vertex;  ///< `z_by_node`, and those of the rest
  std::vector<Complex> z_of_piece;
  Momentum momentum;

  std::shared_ptr<const RankRows> rows;  ///< of frequencies that yield over several ranks
  YieldingFrames yielding;               ///< of own vertices and ghosts
  bool has_calm = false;
  std::vector<float> calm;    ///< by vertex
  std::vector<float> wanted;  ///< of the last frame, by own vertex and ghost
  std::vector<float> frequencies_of_piece;
  FrequencyTraffic frequency_traffic;

  Communicator& ranks() const { return *surface->ranks; }
  Level& finest() { return hierarchy->finest(); }
  std::vector<SlicedWave>& next_waves() { return options.cycles > 0 ? cancellable_waves : waves; }
  bool descends() const { return options.solver == FrameSolver::multilevel || !has_last; }

  void take_slack();
  void take_input(const FrameInput& frame);
  FrameInput input_of_nodes() const;
  void check_values(const FrameInput& frame) const;
  bool is_kept() const;
  FrameInput yielded(const Progress& progress);
  void start();
  void take_given();
  void keep_frequencies();
  std::vector<float> with_rest(std::span<const float> of_nodes) const;
  FrameResult unchanged_frame() const;
  WaveSet last_waves() const;
};

/// Frequencies yield on all ranks or on none.
void DistributedStripeAnimator::State::take_slack() {
  has_calm = ranks().any(!options.slack.calm.empty());
  calm = owners_values(*surface, options.slack.calm);
  if (!ranks().any(options.slack.yields())) return;
  std::shared_ptr<RankRows> peers;
  if (ranks().size() > 1) {
    peers = std::make_shared<RankRows>(ranks(), surface->graph, options.gather_below);
  }
  yielding = YieldingFrames(YieldingSolver(rank_yielding_setting(*surface, options.slack), peers));
  rows = std::move(peers);
}

/// Own waves from the input, ghosts' from their owners.
void DistributedStripeAnimator::State::take_input(const FrameInput& frame) {
  sent_waves.resize(surface->vertex_count());
  for (std::size_t p = 0; p < frame.positions.size(); ++p) {
    const Index v = surface->vertex_of_piece[p];
    if (v < surface->graph.own) {
      sent_waves[v] = {frame.positions[p], frame.directions[p], frame.frequencies[p]};
    }
  }
  exchange(ranks(), surface->graph.halo, std::span(sent_waves));
  input.positions.resize(sent_waves.size());
  input.directions.resize(sent_waves.size());
  input.frequencies.resize(sent_waves.size());
  for (std::size_t v = 0; v < sent_waves.size(); ++v) {
    input.positions[v] = sent_waves[v].position;
    input.directions[v] = sent_waves[v].direction;
    input.frequencies[v] = sent_waves[v].frequency;
  }
}

/// What `check_values` of frame_input.h refuses of the whole, by what owners say.
void DistributedStripeAnimator::State::check_values(const FrameInput& frame) const {
  const std::size_t own = surface->graph.own;
  std::vector<Vec3> normals(own, Vec3::Zero());
  bool is_in_place = true;
  for (std::size_t v = 0; v < own; ++v) {
    is_in_place = is_in_place && input.positions[v] == surface->mesh.positions[v];
  }
  // Normals that a frame brings are those of the piece's vertices.
  for (std::size_t p = 0; p < surface->vertex_of_piece.size(); ++p) {
    const Index v = surface->vertex_of_piece[p];
    if (v >= own) continue;
    if (!frame.normals.empty()) {
      normals[v] = frame.normals[p];
    } else if (is_in_place) {
      normals[v] = surface->normals[v];
    }
  }
  TangentTally tangent = tally_tangent(normals, std::span(input.directions).first(own));
  const bool own_slant = tangent.slanted > 0;  // a rank without one has no vertex to name
  tangent.counted = ranks().sum(tangent.counted);
  tangent.slanted = ranks().sum(tangent.slanted);
  FinenessTally fineness;
  if (ranks().any(may_be_too_fine(input.positions, input.frequencies))) {
    fineness = tally_fineness(*surface->graph.adjacency, input.positions,
                              std::span(input.directions).first(own), input.frequencies);
  }
  fineness.measured = ranks().sum(fineness.measured);
  fineness.too_fine = ranks().sum(fineness.too_fine);
  ranks().together([&] {
    if (own_slant) check_tangent(tangent);
    check_fineness(fineness);
  });
}

FrameInput DistributedStripeAnimator::State::input_of_nodes() const {
  const std::size_t nodes = surface->graph.node_count();
  return {std::span(input.positions).first(nodes), std::span(input.directions).first(nodes),
          std::span(input.frequencies).first(nodes)};
}

/// Whether frequencies yield, and the input is the last frame's on all ranks.
bool DistributedStripeAnimator::State::is_kept() const {
  return has_last && !has_given && yielding.yields() &&
         !ranks().any(!yielding.is_kept(input_of_nodes()));
}

/// The input of own vertices and ghosts with the frequencies to solve for.
FrameInput DistributedStripeAnimator::State::yielded(const Progress& progress) {
  if (!yielding.yields()) return input_of_nodes();
  const std::uint64_t halo_before = rows ? rows->halo_bytes() : 0;
  const Traffic before = ranks().traffic();
  const FrameInput result = yielding.yielded(input_of_nodes(), on_all(ranks(), progress));
  frequency_traffic = {ranks().traffic().since(before).bytes,
                       rows ? rows->halo_bytes() - halo_before : 0};
  return result;
}

/// The finest level, and what frames write to.
void DistributedStripeAnimator::State::start() {
  if (hierarchy) return;
  Stopwatch watch;
  hierarchy.emplace(ranks(), surface->graph, own_ids(*surface),
                    HierarchyBounds{options.gather_below, options.plan_below});
  const SlicedLayout& layout = finest().layout();
  waves.reserve(layout.slot_count());
  if (options.cycles > 0) cancellable_waves.reserve(layout.slot_count());
  if (options.solver == FrameSolver::relaxation) momentum.m.resize(layout.slot_count());
  degree.resize(layout.slot_count());
  if (options.weights == EdgeWeights::cotangent) {
    const Adjacency& adjacency = *surface->graph.adjacency;
    weights = sliced_weights(layout, adjacency,
                             cotangent_weights(triangles_around_own(*surface), adjacency));
  }
  topology_milliseconds = watch.lap();
}

/// Makes given phases the last ones.
void DistributedStripeAnimator::State::take_given() {
  const SlicedLayout& layout = finest().layout();
  last_z.assign(layout.slot_count(), Complex(0));
  to_slots(layout, given_z, last_z);
  has_last = true;
}

/// Values of own vertices and ghosts, and of the rest of the vertices.
std::vector<float> DistributedStripeAnimator::State::with_rest(
    std::span<const float> of_nodes) const {
  std::vector<float> result(of_nodes.begin(), of_nodes.end());
  result.resize(surface->vertex_count());
  exchange(ranks(), surface->rest, std::span(result));
  return result;
}

void DistributedStripeAnimator::State::keep_frequencies() {
  const std::span<const float> asked = input_of_nodes().frequencies;
  wanted.assign(asked.begin(), asked.end());
  if (!yielding.yields()) return;
  yielding.keep(input_of_nodes());
  const std::vector<float> chosen = with_rest(yielding.frequencies());
  frequencies_of_piece = surface->to_piece(std::span(chosen));
}

FrameResult DistributedStripeAnimator::State::unchanged_frame() const {
  FrameResult result;
  result.z = z_of_piece;
  result.unchanged = true;
  result.frequencies = frequencies_of_piece;
  result.frequency_change = yielding.change();
  return result;
}

DistributedStripeAnimator::DistributedStripeAnimator(const DistributedSurface& surface,
                                                     const DistributedOptions& options)
    : state_(std::make_unique<State>()) {
  state_->surface = surface.shared();
  state_->ranks().together([&] { check_distributed(options); });
  check_on_all(*state_->surface, options.slack);
  state_->options = options;
  state_->take_slack();
  state_->momentum.strength = SolverOptions().momentum;
}

DistributedStripeAnimator::~DistributedStripeAnimator() = default;
DistributedStripeAnimator::DistributedStripeAnimator(DistributedStripeAnimator&&) noexcept =
    default;
DistributedStripeAnimator& DistributedStripeAnimator::operator=(
    DistributedStripeAnimator&&) noexcept = default;

FrameResult DistributedStripeAnimator::frame(const FrameInput& input, const Progress& progress) {
  State& s = *state_;
  s.ranks().together([&] {
    check_frame_input(input, s.surface->vertex_of_piece.size());
    check_waves(input.positions, input.directions, input.frequencies);
  });
  Stopwatch watch;
  s.take_input(input);
  s.check_values(input);
  const double exchange_milliseconds = watch.lap();
  if (s.is_kept()) return s.unchanged_frame();
  const FrameInput yielded = s.yielded(progress);
  const double yield_milliseconds = watch.lap();
  s.start();
  watch.lap();
  // Given phases are of this frame's directions: there is nothing to turn.
  const bool loaded_new =
      load_waves(s.finest().layout(), yielded.positions, yielded.directions, yielded.frequencies,
                 s.next_waves(), s.waves, s.has_given ? std::span<Complex>() : std::span(s.last_z),
                 s.momentum.m);
  // To a rank without vertices nothing changes.
  const bool changed = s.ranks().any(loaded_new && s.surface->graph.own > 0);
  if (s.has_given) {
    s.take_given();
  } else if (s.has_last && !changed) {
    return s.unchanged_frame();
  }
  const double load_milliseconds = watch.lap();
  FrameResult result;
  try {
    result.milliseconds = solve_next(progress);
  } catch (...) {
    take_back();
    throw;
  }
  watch.lap();
  if (s.has_last) {
    result.phase_step = s.ranks().sum(phase_steps(s.finest().z, s.last_z, s.degree)).mean();
  }
  keep();
  result.z = s.z_of_piece;
  result.frequencies = s.frequencies_of_piece;
  result.frequency_change = s.yielding.change();
  result.milliseconds.frequency = yield_milliseconds;
  result.milliseconds.couple += exchange_milliseconds + load_milliseconds;
  result.milliseconds.solve += watch.lap();
  return result;
}

/// From the next waves to phases of the finest level.
FrameMilliseconds DistributedStripeAnimator::solve_next(const Progress& progress) {
  State& s = *state_;
  FrameMilliseconds milliseconds;
  Stopwatch watch;
  couple_next();
  milliseconds.couple = watch.lap();
  const bool builds = !s.hierarchy->is_coarsened();
  if (builds) {
    s.hierarchy->coarsen(progress);
    s.topology_milliseconds += watch.lap();
  }
  if (s.descends() && !builds) s.hierarchy->renew();
  milliseconds.sum = watch.lap();
  if (s.descends()) {
    const SweepPlan plan =
        builds ? SweepPlan::for_new_levels(s.options.sweeps, s.hierarchy->slots_of_all())
               : s.options.sweeps;
    s.hierarchy->descend(plan);
    s.hierarchy->run_cycles(plan, s.options.cycles, progress);
    s.sweeps = plan.on_level(s.hierarchy->slots_of_all()).count * (1 + s.options.cycles);
  } else {
    iterate();
  }
  milliseconds.solve = watch.lap();
  return milliseconds;
}

void DistributedStripeAnimator::couple_next() {
  State& s = *state_;
  Level& finest = s.finest();
  couple(finest.layout(), s.next_waves(), s.options.phase_shift, s.weights, finest.couplings,
         s.degree);
  const bool anchored =
      s.has_last && s.options.lambda > 0 && s.options.solver == FrameSolver::multilevel;
  if (anchored) {
    set_anchors(s.degree, s.last_z, s.options.lambda, finest.couplings.anchor);
  } else {
    finest.couplings.anchor.clear();
  }
}

/// The paper's iterations from the last phases.
void DistributedStripeAnimator::iterate() {
  State& s = *state_;
  std::ranges::transform(s.last_z, s.finest().z.begin(),
                         [](const Complex& z) { return z == Complex(0) ? kPeak : z; });
  for (int iteration = 0; iteration < s.options.iterations; ++iteration) {
    s.hierarchy->relax(s.momentum);
  }
}

/// Makes the frame just solved the last one.
void DistributedStripeAnimator::keep() {
  State& s = *state_;
  const SlicedLayout& layout = s.finest().layout();
  s.last_z.assign(s.finest().z.begin(), s.finest().z.begin() + layout.slot_count());
  to_nodes(layout, s.last_z, s.z_by_node);
  s.z_by_vertex.resize(s.surface->vertex_count());
  std::ranges::copy(s.z_by_node, s.z_by_vertex.begin());
  exchange(s.ranks(), s.surface->rest, std::span(s.z_by_vertex));
  s.z_of_piece = s.surface->to_piece(std::span<const Complex>(s.z_by_vertex));
  if (s.options.cycles > 0) std::swap(s.waves, s.cancellable_waves);
  s.keep_frequencies();
  s.has_frame = s.has_last = true;
  s.has_given = false;
}

/// Makes everything as it was before a frame that has not come to its end.
void DistributedStripeAnimator::take_back() {
  State& s = *state_;
  if (s.has_frame) {
    Level& finest = s.finest();
    turn_phases(s.waves, s.next_waves(), s.last_z);
    turn_phases(s.waves, s.next_waves(), s.momentum.m);
    couple(finest.layout(), s.waves, s.options.phase_shift, s.weights, finest.couplings, s.degree);
    to_slots(finest.layout(), s.z_by_node, finest.z);
  } else {
    // Aggregates follow the couplings of the first frame that comes to its end.
    s.hierarchy.reset();
    s.waves.clear();
    s.has_last = false;
  }
}

double DistributedStripeAnimator::energy() const {
  if (!state_->has_frame) throw Error("animator: there is no energy before the first frame");
  return state_->hierarchy->energy();
}

/// The last frame's waves, by vertex.
WaveSet DistributedStripeAnimator::State::last_waves() const {
  const SlicedLayout& layout = hierarchy->finest().layout();
  std::vector<SentWave> of_vertices(surface->vertex_count());
  for (Index node = 0; node < surface->graph.node_count(); ++node) {
    const SlicedWave& wave = waves[layout.slot_of[node]];
    of_vertices[node] = {Vec3(wave.position), Vec3(wave.direction),
                         yielding.yields() ? yielding.frequencies()[node] : wanted[node]};
  }
  exchange(ranks(), surface->rest, std::span(of_vertices));
  WaveSet result{surface->mesh.positions, {}, {}};
  for (std::size_t v = 0; v < of_vertices.size(); ++v) {
    result.positions[v] = of_vertices[v].position;
    result.directions.push_back(of_vertices[v].direction);
    result.frequencies.push_back(of_vertices[v].frequency);
  }
  return result;
}

DistributedMeasures DistributedStripeAnimator::measure() const {
  const State& s = *state_;
  if (!s.has_frame) throw Error("animator: there is nothing to measure before the first frame");
  const RankSurface& surface = *s.surface;
  WaveSet waves = s.last_waves();
  DistributedMeasures measures;
  const std::vector<CornerPhases> corners =
      corner_phases(surface.mesh.triangles, waves, s.z_by_vertex, s.options.phase_shift);
  Mesh mesh{waves.positions, surface.mesh.triangles};
  QualitySums sums = quality_sums(mesh, waves, corners);
  sums.without_wave =
      count_without_wave(std::span<const Vec3>(waves.directions).first(surface.graph.own));
  measures.quality = quality_of(s.ranks().sum(sums));
  measures.quality.spacing_error_wanted_mean = measures.quality.spacing_error_mean;
  if (s.yielding.yields()) {
    waves.frequencies = s.with_rest(s.wanted);
    measures.quality.spacing_error_wanted_mean =
        quality_of(s.ranks().sum(quality_sums(mesh, waves, corners))).spacing_error_mean;
  }
  if (s.has_calm) {
    measures.quality.branches_in_calm =
        s.ranks().sum(count_in_calm(surface.mesh.triangles, corners, s.calm));
  }
  measures.corners.resize(surface.piece_triangles);
  for (std::size_t t = 0; t < corners.size(); ++t) {
    measures.corners[surface.triangle_of_piece[t]] = corners[t];
  }
  return measures;
}

void DistributedStripeAnimator::set_last_phases(std::span<const Complex> z) {
  State& s = *state_;
  s.ranks().together([&] { check_last_phases(z, s.surface->vertex_of_piece.size()); });
  s.given_z.assign(s.surface->graph.node_count(), Complex(0));
  for (std::size_t p = 0; p < z.size(); ++p) {
    const Index v = s.surface->vertex_of_piece[p];
    if (v < s.surface->graph.own) s.given_z[v] = z[p];
  }
  exchange(s.ranks(), s.surface->graph.halo, std::span(s.given_z));
  s.has_given = true;
}

void DistributedStripeAnimator::set_slack(const Slack& slack) {
  State& s = *state_;
  s.ranks().together([&] { check_made_with_slack(s.yielding.yields()); });
  check_on_all(*s.surface, slack);
  auto setting = rank_yielding_setting(*s.surface, slack);
  const bool differs = setting->triangles.weights != s.yielding.setting().triangles.weights;
  s.yielding.set_setting(std::move(setting), !s.ranks().any(differs));
  s.options.slack = slack;
  s.has_calm = s.ranks().any(!slack.calm.empty());
  s.calm = owners_values(*s.surface, slack.calm);
}

void DistributedStripeAnimator::restart() {
  state_->last_z.clear();
  state_->has_last = state_->has_given = false;
  state_->yielding.restart();
  std::ranges::fill(state_->momentum.m, Complex(0));
}

double DistributedStripeAnimator::topology_milliseconds() const {
  return state_->topology_milliseconds;
}

std::size_t DistributedStripeAnimator::distributed_levels() const {
  return state_->has_frame ? state_->hierarchy->distributed_levels() : 0;
}

int DistributedStripeAnimator::sweeps() const { return state_->sweeps; }

std::size_t DistributedStripeAnimator::halo_bytes() const {
  return state_->has_frame ? state_->hierarchy->halo_bytes(state_->options.sweeps) : 0;
}

FrequencyTraffic DistributedStripeAnimator::frequency_traffic() const {
  return state_->frequency_traffic;
}

std::size_t DistributedStripeAnimator::ghost_count() const {
  return state_->has_frame ? state_->hierarchy->ghost_count()
                           : state_->surface->graph.ghost_count();
}

}  // namespace brindle
