#include "brindle/yielding_frequency.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "brindle/base/parallel.h"
#include "brindle/error.h"
#include "brindle/geometry/neighborhood.h"
#include "brindle/waves/bounded_multigrid.h"
#include "brindle/waves/frequency_rows.h"
#include "brindle/waves/neighbor_triangles.h"

namespace brindle {
namespace {

constexpr int kMostCycles = 40;
constexpr int kMostFrameCycles = 3;
constexpr double kSmallestGain = 1e-3;  ///< of a cycle, over the energy
constexpr float kCalmSlack = 2;         ///< slack that full calm adds, over S
constexpr float kCalmWeight = 9;        ///< weight that it adds

/// Whether a cycle gained so little that no other is worth its time.
bool is_small(double gain, double energy) { return gain <= kSmallestGain * std::abs(energy); }

[[noreturn]] void refuse_slack(const std::string& what, const std::string& remedy) {
  throw Error("slack: " + what + "; " + remedy);
}

void check_list(const std::vector<float>& list, std::size_t vertices, const char* what) {
  if (list.empty() || list.size() == vertices) return;
  refuse_slack("there are " + std::to_string(list.size()) + " " + what + " for " +
                   std::to_string(vertices) + " vertices",
               "give one to each, or none");
}

void check_numbers(const std::vector<float>& list, float most, const char* what,
                   const char* remedy) {
  const auto bad =
      std::find_if_not(list.begin(), list.end(), [most](float s) { return s >= 0 && s <= most; });
  if (bad == list.end()) return;
  refuse_slack(std::string(what) + " of vertex " + std::to_string(bad - list.begin()) + " is " +
                   std::to_string(*bad),
               remedy);
}

/// w_T: calm at the calmest corner counts.
std::vector<float> calm_weights(std::span<const Triangle> triangles, std::span<const float> calm) {
  std::vector<float> weights;
  if (calm.empty()) return weights;
  weights.reserve(triangles.size());
  for (const auto& [a, b, c] : triangles) {
    weights.push_back(1 + kCalmWeight * std::max({calm[a], calm[b], calm[c]}));
  }
  return weights;
}

/// By vertex.
std::vector<float> slack_by_vertex(const Slack& slack, std::size_t vertices) {
  std::vector<float> result =
      slack.by_vertex.empty() ? std::vector<float>(vertices, slack.everywhere) : slack.by_vertex;
  for (std::size_t i = 0; i < slack.calm.size(); ++i) result[i] *= 1 + kCalmSlack * slack.calm[i];
  return result;
}

struct ChangeSums {
  double ratio = 0, count = 0, at_bounds = 0;
  float low = std::numeric_limits<float>::max(), high = 0;
  ChangeSums operator+(const ChangeSums& o) const {
    return {ratio + o.ratio, count + o.count, at_bounds + o.at_bounds, std::min(low, o.low),
            std::max(high, o.high)};
  }
};

}  // namespace

void check(const Slack& slack, std::size_t vertices) {
  constexpr float kMost = std::numeric_limits<float>::max();
  const char* const remedy = "give a finite number of 0 or above";
  if (!(slack.everywhere >= 0 && slack.everywhere <= kMost)) {
    refuse_slack("it is " + std::to_string(slack.everywhere), remedy);
  }
  check_list(slack.by_vertex, vertices, "slacks");
  check_list(slack.calm, vertices, "numbers for calm");
  check_numbers(slack.by_vertex, kMost, "that", remedy);
  check_numbers(slack.calm, 1, "calm", "give a number from 0 to 1");
}

/// What never changes.
struct YieldingFrequency::Setting {
  std::vector<float> slack;  ///< by vertex
  std::vector<Triangle> triangles;
  std::vector<float> weights;  ///< by triangle; empty: 1
  std::shared_ptr<const Adjacency> adjacency;
};

struct YieldingFrequency::State {
  std::shared_ptr<const Setting> setting;
  std::unique_ptr<FrequencyRows> rows;  ///< none before the first `solve`
  std::unique_ptr<BoundedMultigrid> multigrid;
  FrequencyTerms terms;
  std::vector<float> kept;               ///< x by place; empty: none
  std::vector<float> next, frequencies;  ///< by vertex, of the last `solve` and of what was kept
  FrequencyChange change;
  bool settled = false;  ///< whether anything was kept since rows were built

  bool starts() const { return kept.empty(); }
  void build(const FrequencyInput& input);
  void set_bounds();
  void set_start();
  void relax(const Progress& progress);
  void take(std::span<const float> wanted);
};

YieldingFrequency::YieldingFrequency(const Surface& surface, const Slack& slack)
    : state_(std::make_unique<State>()) {
  const Mesh& mesh = surface.mesh;
  check(slack, mesh.vertex_count());
  auto setting = std::make_shared<Setting>();
  setting->slack = slack_by_vertex(slack, mesh.vertex_count());
  if (mesh.triangles.empty()) {
    Mesh joined;
    joined.positions = mesh.positions;
    joined.triangles = neighbor_triangles(mesh.positions, surface.normals, *surface.neighborhood);
    setting->adjacency = std::make_shared<const Adjacency>(vertex_neighborhood(joined));
    setting->triangles = std::move(joined.triangles);
  } else {
    setting->adjacency = surface.neighborhood;
    setting->triangles = mesh.triangles;
  }
  setting->weights = calm_weights(setting->triangles, slack.calm);
  state_->setting = std::move(setting);
}

YieldingFrequency::YieldingFrequency(std::shared_ptr<const Setting> setting)
    : state_(std::make_unique<State>()) {
  state_->setting = std::move(setting);
}

YieldingFrequency YieldingFrequency::sibling() const { return YieldingFrequency(state_->setting); }

YieldingFrequency::~YieldingFrequency() = default;
YieldingFrequency::YieldingFrequency(YieldingFrequency&&) noexcept = default;
YieldingFrequency& YieldingFrequency::operator=(YieldingFrequency&&) noexcept = default;

void YieldingFrequency::State::build(const FrequencyInput& input) {
  auto built = std::make_unique<FrequencyRows>(setting->triangles, setting->weights,
                                               *setting->adjacency, input);
  multigrid = std::make_unique<BoundedMultigrid>(built->levels());
  const std::size_t vertices = setting->slack.size();
  terms.triangles.resize(built->triangles().size());
  next.resize(vertices);
  frequencies.resize(vertices);
  kept.reserve(vertices);
  rows = std::move(built);
  set_bounds();
}

void YieldingFrequency::State::set_bounds() {
  const std::span<float> lower = multigrid->lower(), upper = multigrid->upper();
  for (std::size_t place = 0; place < upper.size(); ++place) {
    upper[place] = 1 + setting->slack[rows->levels()->node_at[place]];
    lower[place] = 1 / upper[place];
  }
}

void YieldingFrequency::State::set_start() {
  if (starts()) {
    multigrid->start();
  } else {
    std::ranges::copy(kept, multigrid->x().begin());
  }
}

/// Until cycles hardly lower the energy.
void YieldingFrequency::State::relax(const Progress& progress) {
  const std::span<const float> right = multigrid->right();
  const auto constant = parallel_sum<double>(right.size(), [&](std::size_t begin, std::size_t end) {
    double part = 0;
    for (std::size_t i = begin; i < end; ++i) part += static_cast<double>(right[i]);
    return part;
  });
  const int most = starts() ? kMostCycles : kMostFrameCycles;
  change = {};
  // A cycle may make little of it and the next one much, above all at the beginning.
  const int enough = starts() ? 2 : 1;
  int small_gains = 0;
  double first_gradient = 0;
  double last = std::numeric_limits<double>::max();
  std::optional<BoundedMultigrid::Measure> end;
  for (int cycle = 0; cycle < most; ++cycle) {
    if (starts()) progress.report("frequency", static_cast<double>(cycle) / most);
    const BoundedMultigrid::Measure measure = multigrid->cycle();
    const double energy = measure.energy + constant;
    if (cycle == 0) first_gradient = measure.projected_gradient;
    change.sweeps += 2;
    small_gains = is_small(last - energy, energy) ? small_gains + 1 : 0;
    if (small_gains == enough) break;
    last = energy;
    // From frame to frame little changes: one cycle may be enough.
    if (starts() || cycle > 0) continue;
    end = multigrid->measure();
    if (is_small(measure.energy - end->energy, energy)) break;
    end.reset();
  }
  if (!end) end = multigrid->measure();
  const double gradient = end->projected_gradient;
  change.residual = first_gradient > 0 ? gradient / first_gradient : 0;
}

/// Frequencies by vertex, and what has become of them.
void YieldingFrequency::State::take(std::span<const float> wanted) {
  BoundedMultigrid& m = *multigrid;
  const auto sums_of = [&](std::size_t begin, std::size_t end) {
    ChangeSums sums;
    for (std::size_t place = begin; place < end; ++place) {
      const Index vertex = rows->levels()->node_at[place];
      const float x = m.x()[place];
      next[vertex] = wanted[vertex] * x;
      if (!(m.diagonal()[place] > 0)) continue;
      sums.ratio += static_cast<double>(x);
      sums.count += 1;
      sums.at_bounds += x <= m.lower()[place] || x >= m.upper()[place];
      sums.low = std::min(sums.low, x);
      sums.high = std::max(sums.high, x);
    }
    return sums;
  };
  const ChangeSums sums = parallel_sum<ChangeSums>(wanted.size(), sums_of);
  if (sums.count == 0) return;
  change.ratio_min = static_cast<double>(sums.low);
  change.ratio_max = static_cast<double>(sums.high);
  change.ratio_mean = sums.ratio / sums.count;
  change.share_at_bounds = sums.at_bounds / sums.count;
}

std::span<const float> YieldingFrequency::solve(std::span<const Vec3> positions,
                                                std::span<const Vec3> directions,
                                                std::span<const float> wanted,
                                                const Progress& progress) {
  State& s = *state_;
  const FrequencyInput input{positions, directions, wanted};
  if (!s.settled) s.build(input);
  set_terms(s.rows->triangles(), input, s.rows->weights(), s.terms);
  s.rows->set(s.terms, wanted, *s.multigrid);
  s.multigrid->prepare();
  s.set_start();
  s.relax(progress);
  s.take(wanted);
  return s.next;
}

void YieldingFrequency::keep() {
  State& s = *state_;
  const std::span<const float> x = s.multigrid->x();
  s.kept.assign(x.begin(), x.end());
  std::swap(s.next, s.frequencies);
  s.settled = true;
}

std::span<const float> YieldingFrequency::frequencies() const { return state_->frequencies; }

void YieldingFrequency::restart() { state_->kept.clear(); }

const FrequencyChange& YieldingFrequency::change() const { return state_->change; }

}  // namespace brindle
