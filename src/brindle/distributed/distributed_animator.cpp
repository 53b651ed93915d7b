#include <algorithm>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "brindle/base/stopwatch.h"
#include "brindle/distributed/levels/rank_hierarchy.h"
#include "brindle/distributed/levels/rank_rows.h"
#include "brindle/distributed/surface/gathered_surface.h"
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
#include "brindle/quality.h"
#include "brindle/waves/wave_check.h"

namespace brindle {
namespace {

// Frames of a distributed surface that rank 0 solves alone.

/// A wave that its owner sends.
struct SentWave {
  Vec3 position;
  Vec3 direction;
  float frequency = 1;
};

/// A StripeAnimator for the whole surface on rank 0, with the bits of one process if triangles are
/// numbered. All functions are collective.
class WholeFrames {
 public:
  /// Tolerances and weights are by vertex of the partition. The surface must outlive this object.
  WholeFrames(const RankSurface& surface, const DistributedOptions& options);

  /// As StripeAnimator::frame, for own vertices. All ranks have `normals`, or none. If `progress`
  /// throws on one rank, all ranks throw.
  FrameResult frame(std::span<const SentWave> own, std::span<const Vec3> normals,
                    const Progress& progress);

  /// `crease_slip` of waves and phases of own vertices.
  std::optional<CreaseSlip> slip(std::span<const SentWave> own, std::span<const Complex> z) const;

  double energy() const;
  void restart();
  /// Of own vertices.
  void set_last_phases(std::span<const Complex> own);
  /// By vertex of the partition.
  void set_slack(const Slack& slack);

  /// Of rank 0.
  double topology_milliseconds() const;

  /// Sweeps of a descent over the finest level, including cycles.
  int sweeps() const;

 private:
  /// The outcome of a frame for all ranks, besides its values.
  struct Outcome {
    bool unchanged = false;
    double phase_step = 0;
    FrequencyChange change;
    FrameMilliseconds milliseconds;
  };

  Slack slack_of_whole(const Slack& of_piece) const;
  FrameInput gather(std::span<const SentWave> own, std::span<const Vec3> normals);

  Communicator& ranks_;
  GatheredSurface whole_;
  AnimatorOptions options_;
  bool has_descended_ = false;
  std::vector<Complex> z_;  ///< of own vertices
  std::vector<float> frequencies_;
  // On rank 0 only.
  std::optional<StripeAnimator> animator_;
  std::vector<SentWave> sent_;
  WaveSet waves_;
  std::vector<Vec3> normals_;
};

/// The waves as lists, which replace those of `waves`.
void list_waves(std::span<const SentWave> sent, WaveSet& waves) {
  waves.positions.resize(sent.size());
  waves.directions.resize(sent.size());
  waves.frequencies.resize(sent.size());
  for (std::size_t v = 0; v < sent.size(); ++v) {
    waves.positions[v] = sent[v].position;
    waves.directions[v] = sent[v].direction;
    waves.frequencies[v] = sent[v].frequency;
  }
}

WholeFrames::WholeFrames(const RankSurface& surface, const DistributedOptions& options)
    : ranks_(*surface.ranks), whole_(surface), options_(options) {
  options_.slack = slack_of_whole(options.slack);
  ranks_.throw_on_all([&] {
    if (!whole_.is_first()) return;
    const Surface& all = whole_.surface();
    if (options.weights == EdgeWeights::cotangent) {
      options_.edge_weights = cotangent_weights(all.mesh, *all.neighborhood);
    }
    animator_.emplace(all, options_);
  });
}

Slack WholeFrames::slack_of_whole(const Slack& of_piece) const {
  Slack slack(of_piece.everywhere);
  if (ranks_.any(!of_piece.by_vertex.empty())) {
    slack.by_vertex = whole_.of_vertices(of_piece.by_vertex);
  }
  if (ranks_.any(!of_piece.branch_penalty.empty()))
    slack.branch_penalty = whole_.of_vertices(of_piece.branch_penalty);
  return slack;
}

FrameInput WholeFrames::gather(std::span<const SentWave> own, std::span<const Vec3> normals) {
  whole_.of_own(own, sent_);
  list_waves(sent_, waves_);
  normals_.clear();
  if (ranks_.any(!normals.empty())) whole_.of_own(normals, normals_);
  return {waves_.positions, waves_.directions, waves_.frequencies, normals_};
}

FrameResult WholeFrames::frame(std::span<const SentWave> own, std::span<const Vec3> normals,
                               const Progress& progress) {
  const FrameInput input = gather(own, normals);
  FrameResult found;
  ranks_.on_first(progress, [&](const Progress& heard) { found = animator_->frame(input, heard); });
  const Outcome outcome = ranks_.all(
      Outcome{found.unchanged, found.phase_step, found.frequency_change, found.milliseconds})[0];
  if (!outcome.unchanged) {
    z_.resize(own.size());
    whole_.to_own(found.z, std::span(z_));
    if (ranks_.any(!found.frequencies.empty())) {
      frequencies_.resize(own.size());
      whole_.to_own(found.frequencies, std::span(frequencies_));
    }
    has_descended_ = true;
  }
  FrameResult result;
  result.z = z_;
  result.phase_step = outcome.phase_step;
  result.unchanged = outcome.unchanged;
  result.frequencies = frequencies_;
  result.frequency_change = outcome.change;
  result.milliseconds = outcome.milliseconds;
  return result;
}

std::optional<CreaseSlip> WholeFrames::slip(std::span<const SentWave> own,
                                            std::span<const Complex> z) const {
  std::vector<SentWave> sent;
  WaveSet waves;
  std::vector<Complex> all_z;
  whole_.of_own(own, sent);
  whole_.of_own(z, all_z);
  list_waves(sent, waves);
  return ranks_.all(whole_.on_first([&](const Surface& all) -> std::optional<CreaseSlip> {
    return crease_slip(all, waves, all_z);
  }))[0];
}

double WholeFrames::energy() const { return ranks_.all(animator_ ? animator_->energy() : 0)[0]; }

void WholeFrames::restart() {
  if (animator_) animator_->restart();
}

void WholeFrames::set_last_phases(std::span<const Complex> own) {
  std::vector<Complex> z;
  whole_.of_own(own, z);
  ranks_.throw_on_all([&] {
    if (animator_) animator_->set_last_phases(z);
  });
}

void WholeFrames::set_slack(const Slack& slack) {
  const Slack of_whole = slack_of_whole(slack);
  ranks_.throw_on_all([&] {
    if (animator_) animator_->set_slack(of_whole);
  });
}

double WholeFrames::topology_milliseconds() const {
  return animator_ ? animator_->topology_milliseconds() : 0;
}

int WholeFrames::sweeps() const {
  if (!has_descended_) return 0;
  // There are hardly more slots than vertices.
  const auto slots = static_cast<Index>(whole_.piece().vertices);
  const SweepPlan plan = SweepPlan::for_new_levels(options_.sweeps, slots);
  return plan.on_level(slots).count * (1 + options_.cycles);
}

void check_distributed(const DistributedOptions& options) {
  check_animator_options(options);
  if (options.phase_shift == PhaseShiftKind::common_source) {
    throw Error("animator options: the phase shift must be aligned or trapezoid");
  }
  if (!options.edge_weights.empty()) {
    throw Error("animator options: distributed surfaces have no weights by edge; take `weights`");
  }
}

/// A progress that throws on all ranks if it throws on one. Both arguments must outlive it.
Progress on_all(Communicator& ranks, const Progress& progress) {
  return Progress([&ranks, &progress](std::string_view stage, double fraction) {
    ranks.throw_on_all([&] { progress.report(stage, fraction); });
    return true;
  });
}

}  // namespace

struct DistributedStripeAnimator::State {
  std::shared_ptr<const RankSurface> surface;
  DistributedOptions options;
  bool yields = false;  ///< a spacing tolerance on any rank
  bool has_penalty = false;
  std::vector<float> branch_penalty;  ///< by vertex

  // The last frame and the present one.
  bool has_frame = false;
  std::vector<SentWave> sent_waves, last_waves;  ///< of own vertices, and often of ghosts
  std::vector<Complex> z_by_vertex, z_of_piece;
  std::vector<float> chosen;  ///< chosen frequencies by vertex, with a spacing tolerance
  std::vector<float> frequencies_of_piece;

  std::optional<WholeFrames>
      whole;  ///< if rank 0 solves alone; otherwise the following members are used

  std::optional<RankHierarchy> hierarchy;  ///< empty before the first frame
  FramePhases phases;                      ///< of own vertices and ghosts
  WaveSet input;                           ///< of own vertices and ghosts
  std::shared_ptr<const RankRows> rows;    ///< of the spacing tolerance over several ranks
  RelaxedFrequencySolver relaxed;          ///< of own vertices and ghosts
  DistributedMetrics metrics;

  Communicator& ranks() const { return *surface->ranks; }
  Level& finest() { return hierarchy->finest(); }

  void take_slack();
  void take_own(const FrameInput& frame);
  std::vector<Vec3> own_normals(const FrameInput& frame) const;
  void take_ghosts();
  FrameInput input_of_nodes() const;
  void check_values(const FrameInput& frame) const;
  bool is_kept() const;
  FrameInput relaxed_input(const Progress& progress);
  void start();
  void keep(std::span<const Complex> z, std::span<const float> frequencies);
  FrameResult kept_frame(const FrameResult& solved) const;
  FrameResult frame_of_whole(const FrameInput& frame, const Progress& progress);
  FrameResult frame_of_pieces(const FrameInput& frame, const Progress& progress);
  void take_back();

  /// Values of all vertices; only those of own ones, or also of ghosts, are set.
  template <class T>
  void share(std::span<const T> known, std::vector<T>& by_vertex) const {
    by_vertex.resize(surface->vertex_count());
    std::ranges::copy(known, by_vertex.begin());
    if (whole) exchange(ranks(), surface->graph.halo, std::span(by_vertex));
    exchange(ranks(), surface->rest, std::span(by_vertex));
  }
};

/// All ranks have a spacing tolerance, or none.
void DistributedStripeAnimator::State::take_slack() {
  yields = ranks().any(options.slack.relaxes());
  has_penalty = ranks().any(!options.slack.branch_penalty.empty());
  branch_penalty = owners_values(*surface, options.slack.branch_penalty);
  if (whole || !yields) return;
  std::shared_ptr<RankRows> peers;
  if (ranks().size() > 1) {
    peers = std::make_shared<RankRows>(ranks(), surface->graph, options.gather_below);
  }
  relaxed = RelaxedFrequencySolver(rank_relaxed_setting(*surface, options.slack), peers);
  rows = std::move(peers);
}

/// Reads own waves from the input.
void DistributedStripeAnimator::State::take_own(const FrameInput& frame) {
  sent_waves.resize(surface->vertex_count());
  for (std::size_t p = 0; p < frame.positions.size(); ++p) {
    const Index v = surface->vertex_of_piece[p];
    if (v < surface->graph.own) {
      sent_waves[v] = {frame.positions[p], frame.directions[p], frame.frequencies[p]};
    }
  }
}

/// The frame's normals of own vertices.
std::vector<Vec3> DistributedStripeAnimator::State::own_normals(const FrameInput& frame) const {
  if (!ranks().any(!frame.normals.empty())) return {};
  std::vector<Vec3> normals(surface->graph.own, Vec3::Zero());
  surface->copy_to_own(frame.normals, std::span(normals));
  return normals;
}

/// Receives ghosts' waves, and fills the arrays.
void DistributedStripeAnimator::State::take_ghosts() {
  exchange(ranks(), surface->graph.halo, std::span(sent_waves));
  list_waves(sent_waves, input);
}

/// Applies the checks of `check_values` in frame_input.h to the owners' values.
void DistributedStripeAnimator::State::check_values(const FrameInput& frame) const {
  const auto own = static_cast<std::ptrdiff_t>(surface->graph.own);
  std::vector<Vec3> normals = own_normals(frame);
  const std::vector<Vec3>& at_rest = surface->mesh.positions;
  if (frame.normals.empty() &&
      std::equal(at_rest.begin(), at_rest.begin() + own, input.positions.begin())) {
    normals.assign(surface->normals.begin(), surface->normals.begin() + own);
  }
  normals.resize(surface->graph.own, Vec3::Zero());
  TangentStats tangent =
      tally_tangent(normals, std::span(input.directions).first(surface->graph.own));
  const bool own_slant = tangent.slanted > 0;  // a rank without one names no vertex
  tangent.counted = ranks().sum(tangent.counted);
  tangent.slanted = ranks().sum(tangent.slanted);
  FinenessTally fineness;
  if (ranks().any(may_be_too_fine(input.positions, input.frequencies))) {
    fineness =
        tally_fineness(*surface->graph.adjacency, input.positions,
                       std::span(input.directions).first(surface->graph.own), input.frequencies);
  }
  fineness.measured = ranks().sum(fineness.measured);
  fineness.too_fine = ranks().sum(fineness.too_fine);
  ranks().throw_on_all([&] {
    if (own_slant) check_tangent(tangent);
    check_fineness(fineness);
  });
}

FrameInput DistributedStripeAnimator::State::input_of_nodes() const {
  const std::size_t nodes = surface->graph.node_count();
  return {std::span(input.positions).first(nodes), std::span(input.directions).first(nodes),
          std::span(input.frequencies).first(nodes)};
}

/// Whether the input equals the last frame's on all ranks, with a spacing tolerance.
bool DistributedStripeAnimator::State::is_kept() const {
  return phases.has_last && !phases.has_given && relaxed.relaxes() &&
         !ranks().any(!relaxed.is_kept(relaxation_of(input_of_nodes())));
}

/// The input of own vertices and ghosts with the frequencies to solve for.
FrameInput DistributedStripeAnimator::State::relaxed_input(const Progress& progress) {
  if (!relaxed.relaxes()) return input_of_nodes();
  const std::uint64_t halo_before = rows ? rows->halo_bytes() : 0;
  const Traffic before = ranks().traffic();
  const FrameInput result =
      brindle::relaxed_input(relaxed, input_of_nodes(), on_all(ranks(), progress));
  metrics.frequency_bytes = ranks().traffic().since(before).bytes;
  metrics.frequency_halo_bytes = rows ? rows->halo_bytes() - halo_before : 0;
  return result;
}

/// Creates the finest level and the outputs of frames.
void DistributedStripeAnimator::State::start() {
  if (hierarchy) return;
  Stopwatch watch;
  hierarchy.emplace(ranks(), surface->graph, options.gather_below);
  const SlicedLayout& layout = finest().layout();
  phases.start(layout);
  if (options.weights == EdgeWeights::cotangent) {
    const Adjacency& adjacency = *surface->graph.adjacency;
    phases.weights = sliced_weights(layout, adjacency,
                                    cotangent_weights(triangles_around_own(*surface), adjacency));
  }
  phases.topology_milliseconds = watch.lap();
}

/// Makes the solved frame the last one; it has values of own vertices, and often of ghosts.
void DistributedStripeAnimator::State::keep(std::span<const Complex> z,
                                            std::span<const float> frequencies) {
  share(z, z_by_vertex);
  z_of_piece = surface->to_piece(std::span<const Complex>(z_by_vertex));
  if (yields) {
    share(frequencies, chosen);
    frequencies_of_piece = surface->to_piece(std::span<const float>(chosen));
  }
  std::swap(sent_waves, last_waves);
  has_frame = true;
}

/// The result with the values of the last frame.
FrameResult DistributedStripeAnimator::State::kept_frame(const FrameResult& solved) const {
  FrameResult result = solved;
  result.z = z_of_piece;
  result.frequencies = frequencies_of_piece;
  return result;
}

DistributedStripeAnimator::DistributedStripeAnimator(const DistributedSurface& surface,
                                                     const DistributedOptions& options)
    : state_(std::make_unique<State>()) {
  state_->surface = surface.shared();
  state_->ranks().throw_on_all([&] { check_distributed(options); });
  check_on_all(*state_->surface, options.slack);
  state_->options = options;
  const std::size_t alone_below = std::max(options.gather_below, options.plan_below);
  const bool is_small = state_->ranks().size() > 1 && state_->surface->vertices < alone_below;
  if (is_small || state_->surface->crease_vertices > 0) {
    state_->whole.emplace(*state_->surface, options);
  }
  state_->take_slack();
  state_->phases = FramePhases(options);
  state_->phases.may_be_taken_back = options.cycles > 0;
}

DistributedStripeAnimator::~DistributedStripeAnimator() = default;
DistributedStripeAnimator::DistributedStripeAnimator(DistributedStripeAnimator&&) noexcept =
    default;
DistributedStripeAnimator& DistributedStripeAnimator::operator=(
    DistributedStripeAnimator&&) noexcept = default;

FrameResult DistributedStripeAnimator::frame(const FrameInput& input, const Progress& progress) {
  State& s = *state_;
  s.ranks().throw_on_all([&] {
    check_frame_input(input, s.surface->vertex_of_piece.size());
    check_waves(input.positions, input.directions, input.frequencies);
  });
  return s.whole ? s.frame_of_whole(input, progress) : s.frame_of_pieces(input, progress);
}

FrameResult DistributedStripeAnimator::State::frame_of_whole(const FrameInput& frame,
                                                             const Progress& progress) {
  Stopwatch watch;
  take_own(frame);
  FrameResult solved =
      whole->frame(std::span(sent_waves).first(surface->graph.own), own_normals(frame), progress);
  if (!solved.unchanged) {
    keep(solved.z, solved.frequencies);
    // All time other than rank 0's work is communication.
    const FrameMilliseconds& known = solved.milliseconds;
    solved.milliseconds.couple +=
        watch.lap() - known.frequency - known.couple - known.sum - known.solve;
  }
  return kept_frame(solved);
}

FrameResult DistributedStripeAnimator::State::frame_of_pieces(const FrameInput& frame,
                                                              const Progress& progress) {
  FrameResult unchanged;
  unchanged.unchanged = true;
  unchanged.frequency_change = relaxed.kept_change();
  FrameClock clock;
  take_own(frame);
  take_ghosts();
  check_values(frame);
  clock.add(&FrameMilliseconds::couple);
  if (is_kept()) return kept_frame(unchanged);
  const FrameInput next = relaxed_input(progress);
  clock.add(&FrameMilliseconds::frequency);
  start();
  clock.lap();
  const bool is_first = !phases.has_last;
  const bool loaded_new = phases.load(finest(), next);
  // A rank without vertices always sees a change.
  if (!ranks().any(loaded_new && (is_first || surface->graph.own > 0))) {
    return kept_frame(unchanged);
  }
  try {
    phases.solve(*hierarchy, options, clock, progress);
  } catch (...) {
    take_back();
    throw;
  }
  FrameResult result;
  result.phase_step = ranks().sum(phases.steps(finest())).mean();
  phases.keep(finest());
  if (yields) relaxed.keep(relaxation_of(input_of_nodes()));
  keep(phases.z_by_node, relaxed.frequencies());
  result.frequency_change = relaxed.kept_change();
  clock.add(&FrameMilliseconds::solve);
  result.milliseconds = clock.spent;
  return kept_frame(result);
}

/// Restores the state before a frame that failed or was cancelled.
void DistributedStripeAnimator::State::take_back() {
  phases.take_back(finest());
  // Aggregates are those of the first completed frame.
  if (!has_frame) hierarchy.reset();
}

double DistributedStripeAnimator::energy() const {
  if (!state_->has_frame) throw Error("animator: there is no energy before the first frame");
  return state_->whole ? state_->whole->energy() : state_->hierarchy->energy();
}

DistributedMeasures DistributedStripeAnimator::measure() const {
  const State& s = *state_;
  if (!s.has_frame) throw Error("animator: there is nothing to measure before the first frame");
  const RankSurface& surface = *s.surface;
  std::vector<SentWave> of_vertices;
  s.share(std::span(s.last_waves).first(s.whole ? surface.graph.own : surface.graph.node_count()),
          of_vertices);
  WaveSet waves;
  list_waves(of_vertices, waves);
  const std::vector<float> wanted = waves.frequencies;
  if (s.yields) waves.frequencies = s.chosen;
  DistributedMeasures measures;
  const std::vector<CornerPhases> corners =
      corner_phases(surface.mesh.triangles, waves, s.z_by_vertex, s.options.phase_shift);
  Mesh mesh{waves.positions, surface.mesh.triangles};
  QualitySums sums = quality_sums(mesh, waves, corners);
  sums.without_wave =
      count_without_wave(std::span<const Vec3>(waves.directions).first(surface.graph.own));
  measures.quality = quality_of(s.ranks().sum(sums));
  measures.quality.spacing_error_wanted_mean = measures.quality.spacing_error_mean;
  if (s.yields) {
    waves.frequencies = wanted;
    measures.quality.spacing_error_wanted_mean =
        quality_of(s.ranks().sum(quality_sums(mesh, waves, corners))).spacing_error_mean;
  }
  if (s.has_penalty) {
    measures.quality.branches_in_avoided_area =
        s.ranks().sum(count_in_avoided_area(surface.mesh.triangles, corners, s.branch_penalty));
  }
  if (s.whole) {
    const Index own = surface.graph.own;
    measures.slip = s.whole->slip(std::span(s.last_waves).first(own),
                                  std::span<const Complex>(s.z_by_vertex).first(own));
  }
  measures.corners.resize(surface.piece_triangles);
  for (std::size_t t = 0; t < corners.size(); ++t) {
    measures.corners[surface.triangle_of_piece[t]] = corners[t];
  }
  return measures;
}

void DistributedStripeAnimator::set_last_phases(std::span<const Complex> z) {
  State& s = *state_;
  s.ranks().throw_on_all([&] { check_last_phases(z, s.surface->vertex_of_piece.size()); });
  std::vector<Complex> given(s.surface->graph.node_count());
  s.surface->copy_to_own(z, std::span(given));
  if (s.whole) return s.whole->set_last_phases(std::span(given).first(s.surface->graph.own));
  exchange(s.ranks(), s.surface->graph.halo, std::span(given));
  s.phases.give(given);
}

void DistributedStripeAnimator::set_slack(const Slack& slack) {
  State& s = *state_;
  s.ranks().throw_on_all([&] { check_made_with_slack(s.yields); });
  check_on_all(*s.surface, slack);
  if (s.whole) {
    s.whole->set_slack(slack);
  } else {
    auto setting = rank_relaxed_setting(*s.surface, slack);
    const bool differs = setting->triangles.weights != s.relaxed.setting().triangles.weights;
    s.relaxed.set_setting(std::move(setting), !s.ranks().any(differs));
  }
  s.options.slack = slack;
  s.has_penalty = s.ranks().any(!slack.branch_penalty.empty());
  s.branch_penalty = owners_values(*s.surface, slack.branch_penalty);
}

void DistributedStripeAnimator::restart() {
  State& s = *state_;
  if (s.whole) return s.whole->restart();
  s.phases.restart();
  s.relaxed.restart();
}

DistributedMetrics DistributedStripeAnimator::metrics() const {
  const State& s = *state_;
  DistributedMetrics metrics = s.metrics;
  metrics.ghosts = s.surface->graph.ghost_count();
  if (s.whole) {
    metrics.topology_milliseconds = s.whole->topology_milliseconds();
    metrics.sweeps = s.whole->sweeps();
  } else if (s.has_frame) {
    metrics.topology_milliseconds = s.phases.topology_milliseconds;
    metrics.sweeps = s.phases.sweeps;
    metrics.distributed_levels = s.hierarchy->distributed_levels();
    metrics.halo_bytes = s.hierarchy->halo_bytes(s.options.sweeps);
  }
  return metrics;
}

}  // namespace brindle
