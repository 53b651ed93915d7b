#include "brindle/waves/yielding_solver.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <utility>

#include "brindle/base/parallel.h"
#include "brindle/waves/slack_check.h"

namespace brindle {
namespace {

constexpr int kMostCycles = 40;
constexpr int kMostFrameCycles = 3;
constexpr double kSmallestGain = 1e-3;  ///< of a cycle, over the energy
constexpr float kCalmSlack = 2;         ///< slack that full calm adds, over S
constexpr float kCalmWeight = 9;        ///< weight that it adds

/// Whether a cycle gained so little that no other is worth its time.
bool is_small(double gain, double energy) { return gain <= kSmallestGain * std::abs(energy); }

struct ChangeSums {
  double ratio = 0, count = 0, at_bounds = 0;
  float low = std::numeric_limits<float>::max(), high = 0;
  ChangeSums operator+(const ChangeSums& o) const {
    return {ratio + o.ratio, count + o.count, at_bounds + o.at_bounds, std::min(low, o.low),
            std::max(high, o.high)};
  }
};

ChangeSums over_all(RowPeers* peers, const ChangeSums& own) {
  if (peers == nullptr) return own;
  std::array<double, 3> sums = {own.ratio, own.count, own.at_bounds};
  peers->sum(sums);
  const double low = peers->least(static_cast<double>(own.low));
  const double high = -peers->least(-static_cast<double>(own.high));
  return {sums[0], sums[1], sums[2], static_cast<float>(low), static_cast<float>(high)};
}

}  // namespace

std::vector<float> calm_weights(std::span<const Triangle> triangles, std::span<const float> calm) {
  std::vector<float> weights;
  if (calm.empty()) return weights;
  weights.reserve(triangles.size());
  for (const auto& [a, b, c] : triangles) {
    weights.push_back(1 + kCalmWeight * std::max({calm[a], calm[b], calm[c]}));
  }
  return weights;
}

std::vector<float> slack_by_vertex(const Slack& slack, std::size_t vertices) {
  std::vector<float> result =
      slack.by_vertex.empty() ? std::vector<float>(vertices, slack.everywhere) : slack.by_vertex;
  for (std::size_t i = 0; i < slack.calm.size(); ++i) result[i] *= 1 + kCalmSlack * slack.calm[i];
  return result;
}

YieldingSolver::YieldingSolver(std::shared_ptr<const YieldingSetting> setting,
                               std::shared_ptr<RowPeers> peers)
    : setting_(std::move(setting)), peers_(std::move(peers)) {}

void YieldingSolver::build(const FrequencyInput& input, const Progress& progress) {
  auto built = std::make_unique<FrequencyRows>(setting_->triangles, *setting_->adjacency, input,
                                               peers_.get(), progress.part(0, 0.8));
  progress.report(0.8);
  auto multigrid = std::make_unique<BoundedMultigrid>(built->levels(), peers_.get());
  const std::size_t vertices = setting_->slack.size();
  reported_resize(terms_.triangles, built->triangles().corners.size(), progress.part(0.9, 1));
  next_.resize(vertices);
  frequencies_.resize(vertices);
  kept_.reserve(vertices);
  rows_ = std::move(built);
  multigrid_ = std::move(multigrid);
  set_bounds();
}

void YieldingSolver::set_bounds() {
  const std::span<float> lower = multigrid_->lower(), upper = multigrid_->upper();
  for (std::size_t place = 0; place < upper.size(); ++place) {
    upper[place] = 1 + setting_->slack[rows_->levels()->node_at[place]];
    lower[place] = 1 / upper[place];
  }
}

void YieldingSolver::set_slack(const Slack& slack) {
  check_slack(slack, setting_->slack.size());
  auto setting = std::make_shared<YieldingSetting>(*setting_);
  setting->slack = slack_by_vertex(slack, setting->slack.size());
  setting->triangles.weights = calm_weights(setting->triangles.corners, slack.calm);
  const bool weighs_as_before = setting->triangles.weights == setting_->triangles.weights;
  setting_ = std::move(setting);
  if (!weighs_as_before) {
    settled_ = false;
    starts_ = true;
  } else if (rows_) {
    set_bounds();
    other_bounds_ = true;
  }
}

void YieldingSolver::set_start(const Progress& progress) {
  if (starts_) return multigrid_->start(progress);
  const std::span<const float> lower = multigrid_->lower(), upper = multigrid_->upper();
  for (std::size_t place = 0; place < kept_.size(); ++place) {
    multigrid_->x()[place] = std::clamp(kept_[place], lower[place], upper[place]);
  }
}

/// Until cycles hardly lower the energy.
void YieldingSolver::relax(const Progress& progress) {
  const std::span<const float> right = multigrid_->right();
  auto constant = parallel_sum<double>(right.size(), [&](std::size_t begin, std::size_t end) {
    double part = 0;
    for (std::size_t i = begin; i < end; ++i) part += static_cast<double>(right[i]);
    return part;
  });
  if (peers_) peers_->sum({&constant, 1});
  const bool goes_far = starts_ || other_bounds_;
  const int most = goes_far ? kMostCycles : kMostFrameCycles;
  change_ = {};
  // A cycle may make little of it and the next one much, above all at the beginning.
  const int enough = goes_far ? 2 : 1;
  int small_gains = 0;
  double first_gradient = 0;
  double last = std::numeric_limits<double>::max();
  std::optional<BoundedMultigrid::Measure> end;
  for (int cycle = 0; cycle < most; ++cycle) {
    const Progress of_cycle =
        progress.part(static_cast<double>(cycle) / most, static_cast<double>(cycle + 1) / most);
    if (starts_) of_cycle.report(0);
    const BoundedMultigrid::Measure measure = multigrid_->cycle(inner(of_cycle));
    const double energy = measure.energy + constant;
    if (cycle == 0) first_gradient = measure.projected_gradient;
    change_.sweeps += 2;
    small_gains = is_small(last - energy, energy) ? small_gains + 1 : 0;
    if (small_gains == enough) break;
    last = energy;
    // From frame to frame little changes: one cycle may be enough.
    if (goes_far || cycle > 0) continue;
    end = multigrid_->measure();
    if (is_small(measure.energy - end->energy, energy)) break;
    end.reset();
  }
  if (!end) end = multigrid_->measure();
  const double gradient = end->projected_gradient;
  change_.residual = first_gradient > 0 ? gradient / first_gradient : 0;
}

/// Frequencies by vertex, and what has become of them.
void YieldingSolver::take(std::span<const float> wanted) {
  BoundedMultigrid& m = *multigrid_;
  const std::vector<Index>& node_at = rows_->levels()->node_at;
  const std::size_t own = rows_->own();
  const auto sums_of = [&](std::size_t begin, std::size_t end) {
    ChangeSums sums;
    for (std::size_t place = begin; place < end; ++place) {
      const float x = m.x()[place];
      next_[node_at[place]] = wanted[node_at[place]] * x;
      if (!(m.diagonal()[place] > 0)) continue;
      sums.ratio += static_cast<double>(x);
      sums.count += 1;
      sums.at_bounds += x <= m.lower()[place] || x >= m.upper()[place];
      sums.low = std::min(sums.low, x);
      sums.high = std::max(sums.high, x);
    }
    return sums;
  };
  const ChangeSums sums = over_all(peers_.get(), parallel_sum<ChangeSums>(own, sums_of));
  for (std::size_t other = own; other < wanted.size(); ++other) {
    next_[other] = wanted[other] * m.x()[other];
  }
  if (sums.count == 0) return;
  change_.ratio_min = static_cast<double>(sums.low);
  change_.ratio_max = static_cast<double>(sums.high);
  change_.ratio_mean = sums.ratio / sums.count;
  change_.share_at_bounds = sums.at_bounds / sums.count;
}

std::span<const float> YieldingSolver::solve(const FrequencyInput& input, const Progress& heard) {
  const Progress progress = heard.step("frequency");
  const auto report = [&](double done) {
    if (starts_) progress.report(done);
  };
  report(0);
  if (!settled_) build(input, inner(progress.part(0, 0.2)));
  report(0.2);
  rows_->set_terms(input, peers_.get(), terms_, inner(progress.part(0.2, 0.22)));
  report(0.22);
  rows_->set(terms_, input.wanted, *multigrid_);
  report(0.24);
  multigrid_->prepare();
  set_start(inner(progress.part(0.24, 0.3)));
  relax(progress.part(0.3, 0.95));
  report(0.95);
  take(input.wanted);
  report(1);
  return next_;
}

void YieldingSolver::keep() {
  const std::span<const float> x = multigrid_->x();
  kept_.assign(x.begin(), x.end());
  std::swap(next_, frequencies_);
  settled_ = true;
  starts_ = false;
  other_bounds_ = false;
}

}  // namespace brindle
