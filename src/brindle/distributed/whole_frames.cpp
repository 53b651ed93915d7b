#include "brindle/distributed/whole_frames.h"

#include "brindle/geometry/measures.h"
#include "brindle/phases/multilevel.h"

namespace brindle {

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

}  // namespace brindle
