#include "brindle/waves/bounded_multigrid.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

#include "brindle/base/parallel.h"
#include "brindle/base/standard.h"

namespace brindle {
namespace {

constexpr std::size_t kBlockGrain = 4;  ///< fewest blocks per task
constexpr std::size_t kCopyGrain = 65536;
constexpr int kCoarseVisits = 2;  ///< by each finer level but the finest: a W cycle
constexpr int kCoarsestSweeps = 8;
/// Above 1, because corrections that are constant on aggregates are too short.
constexpr double kLongestStep = 2;
constexpr double kMostChanged = 64;  ///< levels are summed again when one node in 64 has changed

struct MeasureSums {
  double energy = 0, square = 0, changed = 0;
  MeasureSums operator+(const MeasureSums& o) const {
    return {energy + o.energy, square + o.square, changed + o.changed};
  }
  std::array<double, 3> numbers() const { return {energy, square, changed}; }
  static MeasureSums of(const std::array<double, 3>& n) { return {n[0], n[1], n[2]}; }
};

/// Products for the energy along the correction s and the last cycle's step m.
struct StepSums {
  double rs = 0, rm = 0, ss = 0, sm = 0, mm = 0;
  StepSums operator+(const StepSums& o) const {
    return {rs + o.rs, rm + o.rm, ss + o.ss, sm + o.sm, mm + o.mm};
  }
  std::array<double, 5> numbers() const { return {rs, rm, ss, sm, mm}; }
  static StepSums of(const std::array<double, 5>& n) { return {n[0], n[1], n[2], n[3], n[4]}; }
};

struct StepLengths {
  double correction = 0, momentum = 0;
};

/// The lengths with the least energy.
StepLengths best_lengths(const StepSums& sums, double longest) {
  const double determinant = sums.ss * sums.mm - sums.sm * sums.sm;
  if (determinant > 1e-6 * sums.ss * sums.mm) {
    return {(sums.rs * sums.mm - sums.rm * sums.sm) / determinant,
            (sums.rm * sums.ss - sums.rs * sums.sm) / determinant};
  }
  return {sums.ss > 0 ? std::clamp(sums.rs / sums.ss, 0.0, longest) : 0.0, 0.0};
}

template <class Body>
void for_rows(const RowLevel& rows, const Body& body) {
  parallel_for(
      rows.block_count(),
      [&](std::size_t begin, std::size_t end) {
        const Index last = std::min(rows.size(), static_cast<Index>(end) * kRowBlock);
        for (Index i = static_cast<Index>(begin) * kRowBlock; i < last; ++i) body(i);
      },
      kBlockGrain);
}

/// The same, including ghosts.
template <class Body>
void for_places(const RowLevel& rows, const Body& body) {
  for_rows(rows, body);
  for (Index i = rows.size(); i < rows.size_with_others(); ++i) body(i);
}

/// The sum over all rows of what `add(i, sum)` adds.
template <class Sum, class Add>
Sum sum_over_rows(const RowLevel& rows, const Add& add) {
  return parallel_sum<Sum>(
      rows.block_count(),
      [&](std::size_t begin, std::size_t end) {
        Sum sum;
        const Index last = std::min(rows.size(), static_cast<Index>(end) * kRowBlock);
        for (Index i = static_cast<Index>(begin) * kRowBlock; i < last; ++i) add(i, sum);
        return sum;
      },
      kBlockGrain);
}

/// Row i of the product with `x`, without the diagonal.
float row_product(const RowLevel& rows, const std::vector<float>& values,
                  const std::vector<float>& x, Index i) {
  float sum = 0;
  for (Index e = rows.offsets[i]; e < rows.offsets[i + 1]; ++e) {
    sum += values[e] * x[rows.columns[e]];
  }
  return sum;
}

}  // namespace

BoundedMultigrid::BoundedMultigrid(std::shared_ptr<const RowLevels> levels, MultigridPeers* peers)
    : rows_(std::move(levels)), peers_(peers) {
  for (const RowLevel& rows : rows_->levels) {
    Level& level = levels_.emplace_back();
    level.values.resize(rows.columns.size());
    for (auto* v : {&level.diagonal, &level.inverse, &level.right}) v->resize(rows.size());
    for (auto* v : {&level.x, &level.lower, &level.upper}) v->resize(rows.size_with_others());
    level.last.resize(rows.block_count() > 1 || peers_ != nullptr ? level.x.size() : 0);
  }
  const RowLevel& finest = rows_->levels[0];
  for (auto* v : {&residual_, &last_residual_}) v->resize(finest.size());
  for (auto* v : {&step_, &free_, &last_x_}) v->resize(finest.size_with_others());
  nodes_of_all_ = finest.size();
  if (peers_ != nullptr) peers_->sum({&nodes_of_all_, 1});
}

void BoundedMultigrid::prepare() {
  weigh(0);
  summed_ = false;
  last_energy_ = std::numeric_limits<double>::infinity();
  longest_step_ = kLongestStep;
  has_momentum_ = false;
}

void BoundedMultigrid::prepare_without_bounds() {
  weigh(0);
  ranges::fill(free_, 1.0f);
  sum_all();
}

void BoundedMultigrid::start_as_coarser() {
  weigh(0);
  start_with(kCoarsestSweeps);
}

void BoundedMultigrid::solve_without_bounds(int visits) {
  ranges::fill(levels_[0].x, 0.0f);
  for (int n = 0; n < visits; ++n) descend(0);
}

/// The divisor of a residual: the diagonal plus the magnitudes of entries of other blocks.
void BoundedMultigrid::weigh(std::size_t l) {
  const RowLevel& rows = rows_->levels[l];
  Level& level = levels_[l];
  for_rows(rows, [&](Index i) {
    float sum = level.diagonal[i];
    for (Index e = rows.outside[i]; e < rows.offsets[i + 1]; ++e) sum += std::abs(level.values[e]);
    level.inverse[i] = sum > 0 ? 1 / sum : 0;
  });
}

/// The coarser level's matrix: sums over free nodes.
void BoundedMultigrid::sum(std::size_t l) {
  const RowLevel& fine = rows_->levels[l];
  const RowLevel& coarse = rows_->levels[l + 1];
  const Level& from = levels_[l];
  Level& to = levels_[l + 1];
  for_rows(coarse, [&](Index parent) {
    for (Index e = coarse.offsets[parent]; e < coarse.offsets[parent + 1]; ++e) to.values[e] = 0;
    float diagonal = 0;
    for (Index i = fine.children[parent]; i < fine.children[parent + 1]; ++i) {
      if (l == 0 && free_[i] == 0) continue;
      diagonal += from.diagonal[i];
      for (Index e = fine.offsets[i]; e < fine.offsets[i + 1]; ++e) {
        const float value = l == 0 ? from.values[e] * free_[fine.columns[e]] : from.values[e];
        if (fine.target[e] == kInsideParent) {
          diagonal += value;
        } else {
          to.values[fine.target[e]] += value;
        }
      }
    }
    to.diagonal[parent] = diagonal;
  });
  weigh(l + 1);
}

void BoundedMultigrid::sum_all(const Progress& progress) {
  for (std::size_t l = 0; !is_coarsest(l); ++l) {
    progress.tick();
    sum(l);
  }
  if (peers_ != nullptr && levels_.size() > 1) {
    peers_->set_coarsest({levels_.back().values, levels_.back().diagonal});
  }
}

template <bool kBounded>
void BoundedMultigrid::relax_block(std::size_t l, std::size_t block, bool forward) {
  const RowLevel& rows = rows_->levels[l];
  Level& level = levels_[l];
  const float* const values = level.values.data();
  const float* const last = level.last.data();
  const Index* const columns = rows.columns.data();
  float* const x = level.x.data();
  const auto relax = [&](Index i) {
    float residual = level.right[i] - level.diagonal[i] * x[i];
    const Index outside = rows.outside[i], end = rows.offsets[i + 1];
    for (Index e = rows.offsets[i]; e < outside; ++e) residual -= values[e] * x[columns[e]];
    for (Index e = outside; e < end; ++e) residual -= values[e] * last[columns[e]];
    float now = x[i] + residual * level.inverse[i];
    if constexpr (kBounded) now = std::min(std::max(now, level.lower[i]), level.upper[i]);
    x[i] = now;
  };
  const Index first = static_cast<Index>(block) * kRowBlock;
  const Index behind = std::min(rows.size(), first + kRowBlock);
  if (forward) {
    for (Index i = first; i < behind; ++i) relax(i);
  } else {
    for (Index i = behind; i-- > first;) relax(i);
  }
}

template <bool kBounded>
void BoundedMultigrid::relax_blocks(std::size_t l, std::span<const Index> blocks, bool forward) {
  parallel_for(
      blocks.size(),
      [&](std::size_t begin, std::size_t end) {
        for (std::size_t b = begin; b < end; ++b) relax_block<kBounded>(l, blocks[b], forward);
      },
      kBlockGrain);
}

/// Relaxes border blocks first, so that their values are sent while the others are relaxed.
template <bool kBounded>
void BoundedMultigrid::sweep(std::size_t l, bool forward) {
  Level& level = levels_[l];
  parallel_for(
      level.last.size(),
      [&](std::size_t begin, std::size_t end) {
        std::copy(level.x.begin() + static_cast<std::ptrdiff_t>(begin),
                  level.x.begin() + static_cast<std::ptrdiff_t>(end),
                  level.last.begin() + static_cast<std::ptrdiff_t>(begin));
      },
      kCopyGrain);
  if (peers_ != nullptr) {
    relax_blocks<kBounded>(l, peers_->border_blocks(l), forward);
    peers_->start(l, level.x);
    relax_blocks<kBounded>(l, peers_->inner_blocks(l), forward);
    peers_->finish();
    return;
  }
  parallel_for(
      rows_->levels[l].block_count(),
      [&](std::size_t begin, std::size_t end) {
        for (std::size_t block = begin; block < end; ++block) {
          relax_block<kBounded>(l, block, forward);
        }
      },
      kBlockGrain);
}

void BoundedMultigrid::exchange(std::size_t level, std::span<float> by_place) {
  if (peers_ == nullptr) return;
  peers_->start(level, by_place);
  peers_->finish();
}

/// Sums residuals of level l into the right side of the next level.
template <class Residual>
void BoundedMultigrid::restrict_sums(std::size_t l, const Residual& residual) {
  const RowLevel& fine = rows_->levels[l];
  Level& to = levels_[l + 1];
  for_rows(rows_->levels[l + 1], [&](Index parent) {
    float sum = 0;
    for (Index i = fine.children[parent]; i < fine.children[parent + 1]; ++i) sum += residual(i);
    to.right[parent] = sum;
  });
  ranges::fill(to.x, 0.0f);
}

void BoundedMultigrid::restrict_free_residual() {
  restrict_sums(0, [&](Index i) { return residual_[i] * free_[i]; });
}

void BoundedMultigrid::restrict_residual(std::size_t l) {
  const RowLevel& fine = rows_->levels[l];
  const Level& from = levels_[l];
  restrict_sums(l, [&](Index i) {
    return from.right[i] - from.diagonal[i] * from.x[i] - row_product(fine, from.values, from.x, i);
  });
}

/// Restricts the right side, and the bounds that are common to all children.
void BoundedMultigrid::restrict_bounds(std::size_t l) {
  const RowLevel& fine = rows_->levels[l];
  const Level& from = levels_[l];
  Level& to = levels_[l + 1];
  for_rows(rows_->levels[l + 1], [&](Index parent) {
    float right = 0, lower = 0, upper = std::numeric_limits<float>::max();
    for (Index i = fine.children[parent]; i < fine.children[parent + 1]; ++i) {
      right += from.right[i];
      lower = std::max(lower, from.lower[i]);
      upper = std::min(upper, from.upper[i]);
    }
    to.right[parent] = right;
    to.lower[parent] = lower;
    to.upper[parent] = upper;
  });
}

void BoundedMultigrid::start(const Progress& progress) { start_with(0, progress); }

void BoundedMultigrid::start_with(int finest_sweeps, const Progress& progress) {
  ranges::fill(free_, 1.0f);
  sum_all(progress);
  for (std::size_t l = 0; !is_coarsest(l); ++l) restrict_bounds(l);
  ranges::fill(levels_.back().x, 1.0f);
  const bool is_solved = peers_ != nullptr && levels_.size() > 1;
  if (is_solved) {
    const Level& coarsest = levels_.back();
    peers_->start_coarsest({coarsest.right, coarsest.lower, coarsest.upper}, levels_.back().x);
  }
  for (std::size_t l = levels_.size() - (is_solved ? 1 : 0); l-- > 0;) {
    Level& level = levels_[l];
    progress.tick();
    if (!is_coarsest(l)) {
      const RowLevel& rows = rows_->levels[l];
      for_rows(rows, [&](Index i) {
        level.x[i] = level.diagonal[i] > 0 ? levels_[l + 1].x[rows.parent[i]] : 1;
      });
      exchange(l, level.x);
    }
    const int sweeps = l == 0 ? finest_sweeps : kCoarsestSweeps;
    for (int s = 0; s < sweeps; ++s) {
      progress.tick();
      sweep<true>(l, s % 2 == 0);
    }
  }
}

void BoundedMultigrid::correct(std::size_t l) {
  const RowLevel& rows = rows_->levels[l];
  const std::vector<float>& coarse = levels_[l + 1].x;
  for_places(rows, [&](Index i) { levels_[l].x[i] += coarse[rows.parent[i]]; });
}

void BoundedMultigrid::visit(std::size_t l, int visits) {
  if (is_coarsest(l) && peers_ != nullptr) {
    return peers_->solve_coarsest(levels_[l].right, visits, levels_[l].x);
  }
  for (int n = 0; n < visits; ++n) descend(l);
}

void BoundedMultigrid::descend(std::size_t l) {
  if (is_coarsest(l)) {
    for (int s = 0; s < kCoarsestSweeps; ++s) {
      sweep<false>(l, true);
      sweep<false>(l, false);
    }
    return;
  }
  sweep<false>(l, true);
  restrict_residual(l);
  visit(l + 1, kCoarseVisits);
  correct(l);
  sweep<false>(l, false);
}

BoundedMultigrid::Measure BoundedMultigrid::measure() {
  const RowLevel& rows = rows_->levels[0];
  const Level& level = levels_[0];
  const auto own = sum_over_rows<MeasureSums>(rows, [&](Index i, MeasureSums& sum) {
    const float x = level.x[i];
    const float r =
        level.right[i] - level.diagonal[i] * x - row_product(rows, level.values, level.x, i);
    // Rows without a diagonal do not change either.
    const bool held = (x <= level.lower[i] && r <= 0) || (x >= level.upper[i] && r >= 0) ||
                      !(level.diagonal[i] > 0);
    const float free = held ? 0.0f : 1.0f;
    sum.changed += free != free_[i];
    residual_[i] = r;
    free_[i] = free;
    sum.energy -= static_cast<double>(x) * static_cast<double>(r + level.right[i]);
    if (!held) sum.square += static_cast<double>(r) * static_cast<double>(r);
  });
  const MeasureSums sums = over_all(peers_, own);
  changed_ += sums.changed;
  return {sums.energy, std::sqrt(sums.square)};
}

/// Adds the projected correction of the coarser levels and a share of the last cycle's step. The
/// product of the matrix with that step follows from the residuals before and after it.
void BoundedMultigrid::step() {
  const RowLevel& rows = rows_->levels[0];
  Level& level = levels_[0];
  const std::vector<float>& coarse = levels_[1].x;
  const auto within = [&](float x, Index i) {
    return std::min(std::max(x, level.lower[i]), level.upper[i]);
  };
  for_places(rows, [&](Index i) {
    step_[i] = within(level.x[i] + free_[i] * coarse[rows.parent[i]], i) - level.x[i];
  });
  const auto own = sum_over_rows<StepSums>(rows, [&](Index i, StepSums& sum) {
    const double r = residual_[i], s = step_[i];
    sum.rs += s * r;
    sum.ss += s * static_cast<double>(level.diagonal[i] * step_[i] +
                                      row_product(rows, level.values, step_, i));
    if (!has_momentum_) return;
    const double m = level.x[i] - last_x_[i];
    const double product = last_residual_[i] - residual_[i];
    sum.rm += m * r;
    sum.sm += s * product;
    sum.mm += m * product;
  });
  const StepLengths lengths = best_lengths(over_all(peers_, own), longest_step_);
  const auto correction = static_cast<float>(lengths.correction);
  const auto momentum = static_cast<float>(lengths.momentum);
  for_places(rows, [&](Index i) {
    const float x = level.x[i];
    const float way = has_momentum_ ? x - last_x_[i] : 0;
    last_x_[i] = x;
    level.x[i] = within(x + correction * step_[i] + momentum * way, i);
  });
  std::swap(last_residual_, residual_);
  has_momentum_ = true;
}

/// Corrects by the coarser levels. `free_` is sent while residuals are summed.
void BoundedMultigrid::correct_finest(const Progress& progress) {
  if (peers_ != nullptr) peers_->start(0, free_);
  restrict_free_residual();
  if (peers_ != nullptr) peers_->finish();
  if (!summed_ || changed_ * kMostChanged > nodes_of_all_) {
    sum_all(progress);
    summed_ = true;
    changed_ = 0;
  }
  progress.tick();
  visit(1, 1);
  progress.tick();
  step();
}

BoundedMultigrid::Measure BoundedMultigrid::cycle(const Progress& progress) {
  sweep<true>(0, true);
  progress.tick();
  const Measure now = measure();
  // Long steps are cut at the bounds, which may raise the energy.
  if (now.energy > last_energy_) {
    longest_step_ = 1;
    has_momentum_ = false;
  }
  last_energy_ = now.energy;
  if (levels_.size() > 1) correct_finest(progress);
  progress.tick();
  sweep<true>(0, false);
  return now;
}

}  // namespace brindle
