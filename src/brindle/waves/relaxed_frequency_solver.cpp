#include "brindle/waves/relaxed_frequency_solver.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <utility>

#include "brindle/base/elementary.h"
#include "brindle/base/parallel.h"
#include "brindle/base/standard.h"
#include "brindle/waves/wave_check.h"

namespace brindle {
namespace {

constexpr int kMostCycles = 40;
constexpr int kMostFrameCycles = 3;
constexpr double kSmallestGain = 5e-4;  ///< of a cycle, over the energy
constexpr float kPenaltySlack = 2;      ///< slack that `branch_penalty` = 1 adds, in multiples of S
constexpr float kPenaltyWeight = 9;     ///< weight that `branch_penalty` = 1 adds

/// Whether the gain of a cycle is too small for another one.
bool is_small(double gain, double energy) { return gain <= kSmallestGain * std::abs(energy); }

/// Larger bounds have no effect, and exponentials of smaller ones are floats.
constexpr float kMostLogarithm = 80;

/// Tolerance for the mean of ratios, which becomes 1.
constexpr double kMeanTolerance = 1e-5;

struct ChangeSums {
  double ratio = 0, area = 0, count = 0, at_bounds = 0;
  float low = std::numeric_limits<float>::max(), high = 0;
  ChangeSums operator+(const ChangeSums& o) const {
    return {ratio + o.ratio,         area + o.area,        count + o.count,
            at_bounds + o.at_bounds, std::min(low, o.low), std::max(high, o.high)};
  }
};

ChangeSums over_all(MultigridPeers* peers, const ChangeSums& own) {
  if (peers == nullptr) return own;
  std::array<double, 4> sums = {own.ratio, own.area, own.count, own.at_bounds};
  peers->sum(sums);
  const double low = peers->least(static_cast<double>(own.low));
  const double high = -peers->least(-static_cast<double>(own.high));
  return {sums[0], sums[1], sums[2], sums[3], static_cast<float>(low), static_cast<float>(high)};
}

bool same_bits(const Vec3& a, const Vec3& b) { return a == b; }

/// Copies without allocating if there is room.
void assign(const FrequencyInput& input, WaveSet& waves) {
  waves.positions.assign(input.positions.begin(), input.positions.end());
  waves.directions.assign(input.directions.begin(), input.directions.end());
  waves.frequencies.assign(input.wanted.begin(), input.wanted.end());
}

/// Change of the logarithms over that of their target: first estimate and lower bound.
constexpr float kUsualGain = 0.2f, kLeastGain = 0.02f;

}  // namespace

std::vector<float> penalty_weights(std::span<const Triangle> triangles,
                                   std::span<const float> branch_penalty) {
  std::vector<float> weights;
  if (branch_penalty.empty()) return weights;
  weights.reserve(triangles.size());
  for (const auto& [a, b, c] : triangles) {
    weights.push_back(1 + kPenaltyWeight *
                              std::max({branch_penalty[a], branch_penalty[b], branch_penalty[c]}));
  }
  return weights;
}

std::vector<float> slack_by_vertex(const Slack& slack, std::size_t vertices) {
  std::vector<float> result =
      slack.by_vertex.empty() ? std::vector<float>(vertices, slack.everywhere) : slack.by_vertex;
  for (std::size_t i = 0; i < slack.branch_penalty.size(); ++i)
    result[i] *= 1 + kPenaltySlack * slack.branch_penalty[i];
  return result;
}

RelaxedFrequencySolver::RelaxedFrequencySolver(
    std::shared_ptr<const RelaxedFrequencySetting> setting, std::shared_ptr<MultigridPeers> peers)
    : setting_(std::move(setting)), peers_(std::move(peers)) {}

void RelaxedFrequencySolver::build(const FrequencyInput& input, const Progress& progress) {
  auto built = std::make_unique<FrequencyRows>(setting_->triangles, *setting_->adjacency, input,
                                               peers_.get(), progress);
  progress.tick();
  auto multigrid = std::make_unique<BoundedMultigrid>(built->levels(), peers_.get());
  const std::size_t vertices = setting_->slack.size();
  progress.tick();
  terms_.triangles.resize(built->triangles().corners.size());
  masses_.resize(built->own());
  next_.resize(vertices);
  frequencies_.resize(vertices);
  relaxed_.reserve(vertices);
  kept_.reserve(vertices);
  for (WaveSet* kept : {&kept_input_, &built_for_}) {
    kept->positions.reserve(vertices);
    kept->directions.reserve(vertices);
    kept->frequencies.reserve(vertices);
  }
  rows_ = std::move(built);
  multigrid_ = std::move(multigrid);
  set_bounds();
}

void RelaxedFrequencySolver::set_bounds() {
  const std::span<float> lower = multigrid_->lower(), upper = multigrid_->upper();
  for (std::size_t place = 0; place < upper.size(); ++place) {
    const float most = 1 + setting_->slack[rows_->levels()->node_at[place]];
    const float logarithm = std::min(elementary::log(most), kMostLogarithm);
    upper[place] = 1 + logarithm;
    lower[place] = 1 - logarithm;
  }
}

void RelaxedFrequencySolver::set_slack(const Slack& slack) {
  check_slack(slack, setting_->slack.size());
  auto setting = std::make_shared<RelaxedFrequencySetting>(*setting_);
  setting->slack = slack_by_vertex(slack, setting->slack.size());
  setting->branch_penalty = slack.branch_penalty;
  setting->triangles.weights = penalty_weights(setting->triangles.corners, slack.branch_penalty);
  const bool weighs_as_before = setting->triangles.weights == setting_->triangles.weights;
  set_setting(std::move(setting), weighs_as_before);
}

void RelaxedFrequencySolver::set_setting(std::shared_ptr<const RelaxedFrequencySetting> setting,
                                         bool weighs_as_before) {
  setting_ = std::move(setting);
  has_next_ = has_kept_ = false;
  if (!weighs_as_before) {
    settled_ = false;
    starts_ = true;
  } else if (rows_) {
    set_bounds();
    other_bounds_ = true;
  }
}

void RelaxedFrequencySolver::set_start(const Progress& progress) {
  if (starts_) return multigrid_->start(progress);
  const std::span<const float> lower = multigrid_->lower(), upper = multigrid_->upper();
  for (std::size_t place = 0; place < kept_.size(); ++place) {
    multigrid_->x()[place] = std::clamp(kept_[place], lower[place], upper[place]);
  }
}

/// Runs cycles until they hardly lower the energy.
void RelaxedFrequencySolver::relax(const Progress& progress) {
  auto constant = parallel_sum<double>(masses_.size(), [&](std::size_t begin, std::size_t end) {
    double part = 0;
    for (std::size_t i = begin; i < end; ++i) {
      const double to = 1 + static_cast<double>(target_ * penalty_at(i));
      part += to * to * static_cast<double>(masses_[i].pull);
    }
    return part;
  });
  constant += terms_.constant;
  if (peers_) peers_->sum({&constant, 1});
  const bool goes_far = starts_ || other_bounds_;
  const int most = goes_far ? kMostCycles : kMostFrameCycles;
  // The gain of a cycle may be small and that of the next large, mainly at the beginning.
  const int enough = goes_far ? 2 : 1;
  int small_gains = 0;
  double first_gradient = 0;
  double last = std::numeric_limits<double>::max();
  std::optional<BoundedMultigrid::Measure> end;
  for (int cycle = 0; cycle < most; ++cycle) {
    if (starts_) progress.report(static_cast<double>(cycle) / most);
    const BoundedMultigrid::Measure measure = multigrid_->cycle(inner(progress));
    const double energy = measure.energy + constant;
    if (cycle == 0) first_gradient = measure.projected_gradient;
    change_.sweeps += 2;
    small_gains = is_small(last - energy, energy) ? small_gains + 1 : 0;
    if (small_gains == enough) break;
    last = energy;
    // From frame to frame little changes, so one cycle may be enough.
    if (goes_far || cycle > 0) continue;
    end = multigrid_->measure();
    if (is_small(measure.energy - end->energy, energy)) break;
    end.reset();
  }
  if (!end) end = multigrid_->measure();
  const double gradient = end->projected_gradient;
  change_.residual = first_gradient > 0 ? gradient / first_gradient : 0;
}

float RelaxedFrequencySolver::penalty_at(std::size_t place) const {
  return setting_->branch_penalty.empty()
             ? 0
             : setting_->branch_penalty[rows_->levels()->node_at[place]];
}

/// Sums of ratios if all logarithms were less by `shift`, within their bounds.
RatioSums RelaxedFrequencySolver::ratios(float shift) const {
  BoundedMultigrid& m = *multigrid_;
  const auto sums_of = [&](std::size_t begin, std::size_t end) {
    RatioSums sums;
    for (std::size_t place = begin; place < end; ++place) {
      const float x = m.x()[place] - shift, lower = m.lower()[place], upper = m.upper()[place];
      const auto area = static_cast<double>(masses_[place].area);
      const auto branch_penalty = area * static_cast<double>(penalty_at(place));
      const auto ratio = static_cast<double>(elementary::fast_exp(std::clamp(x, lower, upper) - 1));
      sums.ratio += area * ratio;
      sums.free += x > lower && x < upper ? area * ratio : 0;
      sums.area += area;
      sums.penalized_ratio += branch_penalty * ratio;
      sums.penalized_area += branch_penalty;
    }
    return sums;
  };
  return over_all(peers_.get(), parallel_sum<RatioSums>(rows_->own(), sums_of));
}

/// Shifts all logarithms so that the mean of ratios is 1, since curl does not depend on the scale
/// of frequencies. Newton's method, with bisection where it leaves the bracket; a solution exists,
/// because all bounds include the requested frequencies. Skips vertices without triangles.
RatioSums RelaxedFrequencySolver::shift_to_mean() {
  constexpr int kMostShiftSteps = 40;
  float shift = 0, low = -2 * kMostLogarithm, high = 2 * kMostLogarithm;
  RatioSums sums = ratios(shift);
  for (int step = 0; step < kMostShiftSteps && std::abs(sums.mean() - 1) >= kMeanTolerance;
       ++step) {
    const double excess = sums.mean() - 1;
    (excess > 0 ? low : high) = shift;
    const auto next = static_cast<float>(shift + excess * sums.area / sums.free);
    shift = next > low && next < high ? next : (low + high) / 2;
    sums = ratios(shift);
  }
  BoundedMultigrid& m = *multigrid_;
  relaxed_.assign(m.x().begin(), m.x().end());
  parallel_for(rows_->own(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t place = begin; place < end; ++place) {
      if (!(masses_[place].area > 0)) continue;
      m.x()[place] = std::clamp(m.x()[place] - shift, m.lower()[place], m.upper()[place]);
    }
  });
  if (peers_) {
    peers_->start(0, m.x());
    peers_->finish();
  }
  return sums;
}

void RelaxedFrequencySolver::set_branch_penalty(float target) {
  const std::span<float> right = multigrid_->right();
  const float change = target - target_;
  target_ = target;
  if (change == 0 || setting_->branch_penalty.empty()) return;
  parallel_for(rows_->own(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t place = begin; place < end; ++place) {
      right[place] += change * penalty_at(place) * masses_[place].pull;
    }
  });
}

/// Relaxes until the mean of all ratios is 1, and about 1 under branch avoidance, whose slack and
/// weight would otherwise change the mean there. Moves the target of logarithms there, the farther
/// the less they follow it; between frames by one such step.
void RelaxedFrequencySolver::relax_to_means(const Progress& progress) {
  constexpr int kMostRounds = 5;
  constexpr float kSmallExcess = 0.02f;
  const bool goes_far = starts_ || other_bounds_;
  float step = 0, last = 0;
  change_ = {};
  for (int round = 0;; ++round) {
    relax(setting_->branch_penalty.empty()
              ? progress
              : progress.part(1 - std::pow(0.5, round), 1 - std::pow(0.5, round + 1)));
    const auto excess = static_cast<float>(shift_to_mean().penalized_mean() - 1);
    if (std::abs(excess) < kSmallExcess || round + 1 == kMostRounds) return;
    const float gain = step == 0 ? kUsualGain : std::clamp((last - excess) / step, kLeastGain, 1.f);
    step = excess / gain;
    last = excess;
    set_branch_penalty(target_ - step);
    if (!goes_far) return;
    multigrid_->prepare();
  }
}

/// Sets frequencies by vertex and `change_`.
void RelaxedFrequencySolver::take(std::span<const float> wanted) {
  BoundedMultigrid& m = *multigrid_;
  const std::vector<Index>& node_at = rows_->levels()->node_at;
  const std::size_t own = rows_->own();
  const auto take_ratio = [&](std::size_t place) {
    const Index vertex = node_at[place];
    const float most = 1 + setting_->slack[vertex];
    const float ratio = std::clamp(elementary::fast_exp(m.x()[place] - 1), 1 / most, most);
    next_[vertex] = wanted[vertex] * ratio;
    return ratio;
  };
  const auto sums_of = [&](std::size_t begin, std::size_t end) {
    ChangeSums sums;
    for (std::size_t place = begin; place < end; ++place) {
      const float ratio = take_ratio(place);
      if (!(masses_[place].area > 0)) continue;
      const float x = m.x()[place];
      const auto area = static_cast<double>(masses_[place].area);
      sums.ratio += area * static_cast<double>(ratio);
      sums.area += area;
      sums.count += 1;
      sums.at_bounds += x <= m.lower()[place] || x >= m.upper()[place];
      sums.low = std::min(sums.low, ratio);
      sums.high = std::max(sums.high, ratio);
    }
    return sums;
  };
  const ChangeSums sums = over_all(peers_.get(), parallel_sum<ChangeSums>(own, sums_of));
  for (std::size_t other = own; other < wanted.size(); ++other) take_ratio(other);
  if (sums.count == 0) return;
  change_.ratio_min = static_cast<double>(sums.low);
  change_.ratio_max = static_cast<double>(sums.high);
  change_.ratio_mean = sums.area > 0 ? sums.ratio / sums.area : 1;
  change_.share_at_bounds = sums.at_bounds / sums.count;
}

std::span<const float> RelaxedFrequencySolver::solve(const FrequencyInput& input,
                                                     const Progress& heard) {
  const Progress progress = heard.step("frequency");
  const auto report = [&](double done) {
    if (starts_) progress.report(done);
  };
  has_next_ = false;
  report(0);
  if (!settled_) build(input, inner(progress));
  report(0.2);
  rows_->set_terms(input, peers_.get(), terms_);
  rows_->set(terms_, input.wanted, *multigrid_, masses_);
  report(0.25);
  multigrid_->prepare();
  set_start(inner(progress));
  target_ = 0;
  set_branch_penalty(starts_ ? 0 : kept_target_);
  relax_to_means(progress.part(0.3, 0.95));
  report(0.95);
  take(input.wanted);
  report(1);
  has_next_ = true;
  return next_;
}

void RelaxedFrequencySolver::keep(const FrequencyInput& input) {
  if (!has_next_) return;
  has_next_ = false;
  has_kept_ = true;
  if (!settled_) assign(input, built_for_);
  assign(input, kept_input_);
  kept_change_ = change_;
  std::swap(relaxed_, kept_);
  kept_target_ = target_;
  std::swap(next_, frequencies_);
  settled_ = true;
  starts_ = false;
  other_bounds_ = false;
}

bool RelaxedFrequencySolver::is_kept(const FrequencyInput& input) const {
  return has_kept_ && ranges::equal(input.wanted, kept_input_.frequencies) &&
         ranges::equal(input.directions, kept_input_.directions, same_bits) &&
         ranges::equal(input.positions, kept_input_.positions, same_bits);
}

void RelaxedFrequencySolver::archive(Archive& archive) {
  if (!relaxes()) return;
  const std::size_t vertices = setting_->slack.size();
  bool settled = settled_;
  archive(settled, has_kept_);
  if (settled) {
    archive_waves(archive, vertices, built_for_);
    archive(starts_, other_bounds_, kept_target_);
    archive.list_of(vertices, kept_);
    archive.list_of(vertices, frequencies_);
  }
  if (settled && archive.reads()) {
    const auto is_finite = [](float x) { return std::isfinite(x); };
    if (!is_finite(kept_target_) || !std::all_of(kept_.begin(), kept_.end(), is_finite)) {
      Archive::fail();
    }
    std::vector<float> frequencies = std::move(frequencies_);
    build({built_for_.positions, built_for_.directions, built_for_.frequencies}, {});
    frequencies_ = std::move(frequencies);
    settled_ = true;
  }
  if (!has_kept_) return;
  archive_waves(archive, vertices, kept_input_);
  archive_change(archive, kept_change_);
}

}  // namespace brindle
