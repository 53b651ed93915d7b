#include "brindle/phases/hierarchy.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>

#include "brindle/base/parallel.h"
#include "brindle/base/standard.h"
#include "brindle/base/stopwatch.h"
#include "brindle/phases/coloring.h"
#include "brindle/phases/sliced_kernels.h"

namespace brindle {
namespace {

/// Sets the gauge of the m-th member, reflecting couplings included: the direction of its target
/// from the earlier members of its aggregate, each in its own gauge. The stronger of the two sums
/// decides between Z and conj(Z).
void gauge_reflecting_member(Level& level, std::size_t m) {
  const GaugeSchedule& rounds = level.aggregation().gauges;
  const Index slot = rounds.member[m];
  Complex plain = 0, conjugated = 0;
  for (Index round = rounds.round_begin[m / kLanes]; round < rounds.round_begin[m / kLanes + 1];
       ++round) {
    const std::size_t place = std::size_t{round} * kLanes + m % kLanes;
    const Index entry = rounds.entry[place];
    if (entry == kNone) continue;
    const Complex from = level.gauge[rounds.from[place]];
    const Complex a = level.couplings.direct_at(entry) * from;
    const Complex b =
        level.couplings.reflecting_at(level.layout(), slot / kLanes, entry) * std::conj(from);
    plain += conjugate_bit(from) ? b : a;
    conjugated += conjugate_bit(from) ? a : b;
  }
  const float plain_square = std::norm(plain), conjugated_square = std::norm(conjugated);
  const bool takes_conjugate = conjugated_square > plain_square;
  const Complex sum = takes_conjugate ? conjugated : plain;
  const float length = std::sqrt(std::max(plain_square, conjugated_square));
  level.gauge[slot] = with_conjugate_bit(length > 0 ? sum / length : Complex(1), takes_conjugate);
}

/// Whether the row of a slot has reflecting couplings.
bool reflects(const Level& level, Index slot) {
  const auto list = level.couplings.reflecting_of(level.layout(), slot / kLanes);
  return ranges::any_of(list, [slot](const ReflectingCoupling& coupling) {
    return coupling.entry % kLanes == slot % kLanes;
  });
}

/// Whether any row of a block has reflecting couplings.
bool reflects(const Level& level, SliceRange block) {
  const auto counts = level.couplings.reflecting_count.begin();
  return std::any_of(counts + block.begin, counts + block.end, std::identity());
}

/// Updates the gauges of groups of one rank.
void renew_groups(Level& level, SliceRange groups, bool reflecting) {
  const GaugeSchedule& rounds = level.aggregation().gauges;
  kernels::gauge_members(level.couplings, rounds, level.gauge.data(), groups);
  if (!reflecting) return;
  for (std::size_t m = std::size_t{groups.begin} * kLanes; m < std::size_t{groups.end} * kLanes;
       ++m) {
    const Index slot = rounds.member[m];
    if (slot != kNone && reflects(level, slot)) gauge_reflecting_member(level, m);
  }
}

/// The reflecting sums of one coarse slice.
class ReflectingSums {
 public:
  ReflectingSums(Level& coarse, Index slice, std::vector<Complex>& buffer)
      : coarse_(coarse),
        slice_(slice),
        first_(std::size_t{coarse.layout().column_begin[slice]} * kLanes),
        end_(std::size_t{coarse.layout().column_begin[slice + 1]} * kLanes),
        buffer_(buffer) {
    buffer_.assign(end_ - first_, Complex(0));
  }

  /// Sets the sums of the finer level's direct couplings that link a Z with a conj(Z).
  void set_marked(const SumSchedule& sources, std::span<const Complex> gauged) {
    kernels::sum_marked_slice(coarse_.layout(), sources.round_begin.data(), sources.entry.data(),
                              gauged.data(), buffer_.data(), slice_);
  }

  void add(std::size_t entry, Complex b) { buffer_[entry - first_] += b; }

  void finish() {
    coarse_.couplings.reflecting_count[slice_] = 0;
    for (std::size_t entry = first_; entry < end_; ++entry) {
      const Complex b = buffer_[entry - first_];
      if (b == Complex(0)) continue;
      coarse_.couplings.append_reflecting(coarse_.layout(), slice_, {static_cast<Index>(entry), b});
    }
  }

 private:
  Level& coarse_;
  Index slice_;
  std::size_t first_, end_;
  std::vector<Complex>& buffer_;
};

/// Adds the reflecting couplings of one member of the aggregate in `coarse_slot`: the second column
/// of the table in docs/method.md, "Multilevel solver".
void sum_reflecting(const Level& fine, Index slot, Level& coarse, Index coarse_slot,
                    ReflectingSums& sums) {
  const Complex g_i = fine.gauge[slot];
  for (const auto& [entry, b] : fine.couplings.reflecting_of(fine.layout(), slot / kLanes)) {
    if (entry % kLanes != slot % kLanes) continue;
    const Index j = fine.layout().neighbor[entry];
    const Index neighbor = fine.aggregation().coarse_slot[j];
    if (neighbor == coarse_slot || neighbor == coarse.layout().slot_count()) continue;
    std::size_t target = coarse.layout().first_entry(coarse_slot);
    while (coarse.layout().neighbor[target] != neighbor) target += kLanes;
    const Complex g_j = fine.gauge[j];
    Complex c = std::conj(g_i) * b * std::conj(g_j);
    if (conjugate_bit(g_i)) c = std::conj(c);
    if (conjugate_bit(g_i) == conjugate_bit(g_j)) {
      sums.add(target, c);
    } else {
      coarse.couplings.set_direct(target, coarse.couplings.direct_at(target) + c);
    }
  }
}

/// Adds the reflecting couplings to the sums of a slice; kernels omit them.
void finish_slice(const Level& fine, SumScratch::OfThread& scratch, Level& coarse, Index slice) {
  const Aggregation& aggregation = fine.aggregation();
  ReflectingSums sums(coarse, slice, scratch.reflecting);
  if (scratch.marked[slice]) sums.set_marked(aggregation.sources, scratch.gauged);
  for (Index slot = slice * kLanes; slot < (slice + 1) * kLanes; ++slot) {
    if (!coarse.receives_reflecting[slot]) continue;
    for (Index m = aggregation.member_begin[slot]; m < aggregation.member_begin[slot + 1]; ++m) {
      sum_reflecting(fine, aggregation.member[m], coarse, slot, sums);
    }
  }
  sums.finish();
}

/// Marks the slots of a coarse block that receive reflecting couplings from a fine slice.
void mark_reflecting(const Level& fine, Index fine_slice, SliceRange block, Level& coarse) {
  for (const auto& [entry, b] : fine.couplings.reflecting_of(fine.layout(), fine_slice)) {
    const Index coarse_slot = fine.aggregation().coarse_slot[fine_slice * kLanes + entry % kLanes];
    if (coarse_slot / kLanes < block.begin || coarse_slot / kLanes >= block.end) continue;
    coarse.receives_reflecting[coarse_slot] = 1;
  }
}

/// Multiplies the rows that add to a coarse block by their gauges.
void gauge_block(const Level& fine, Level& coarse, Index block, SumScratch::OfThread& scratch) {
  const SliceRange slices = coarse.layout().block(block);
  std::fill(coarse.receives_reflecting.begin() + slices.begin * kLanes,
            coarse.receives_reflecting.begin() + slices.end * kLanes, std::uint8_t{0});
  Complex* gauged = scratch.gauged.data() + kLanes;
  for (const SliceRange& run : fine.aggregation().sources.runs_of(block)) {
    kernels::gauge_slices(fine.layout(), fine.couplings, fine.gauge.data(), gauged, run);
    gauged +=
        std::size_t{fine.layout().column_begin[run.end] - fine.layout().column_begin[run.begin]} *
        kLanes;
    for (Index slice = run.begin; slice < run.end; ++slice) {
      mark_reflecting(fine, slice, slices, coarse);
    }
  }
}

void sum_block(const Level& fine, Level& coarse, Index block, SumScratch::OfThread& scratch) {
  const SliceRange slices = coarse.layout().block(block);
  gauge_block(fine, coarse, block, scratch);
  kernels::sum_slices(coarse.layout(), fine.aggregation().sources.round_begin.data(),
                      fine.aggregation().sources.entry.data(), scratch.gauged.data(),
                      coarse.couplings.direct.get(), scratch.marked.data(), slices);
  for (Index slice = slices.begin; slice < slices.end; ++slice) {
    const auto receives = coarse.receives_reflecting.begin() + slice * kLanes;
    if (scratch.marked[slice] || std::any_of(receives, receives + kLanes, std::identity())) {
      finish_slice(fine, scratch, coarse, slice);
    } else {
      coarse.couplings.reflecting_count[slice] = 0;
    }
  }
}

void sum_anchors(const Level& fine, Level& coarse, Index slice) {
  const Aggregation& aggregation = fine.aggregation();
  for (Index slot = slice * kLanes; slot < (slice + 1) * kLanes; ++slot) {
    float re = 0, im = 0;
    for (Index m = aggregation.member_begin[slot]; m < aggregation.member_begin[slot + 1]; ++m) {
      const Complex g = fine.gauge[aggregation.member[m]];
      const Complex t = std::conj(g) * fine.couplings.anchor[aggregation.member[m]];
      const auto bits = bit_cast<std::uint32_t>(t.imag());
      re += t.real();
      im += bit_cast<float>(bits ^ (std::uint32_t{conjugate_bit(g)} << 31));  // branch-free
    }
    coarse.couplings.anchor[slot] = {re, im};
  }
}

}  // namespace

Level make_level(LevelTopology topology) {
  const SlicedLayout& layout = *topology.layout;
  SlicedCouplings couplings(layout);
  std::vector<Complex> gauge(layout.slot_count(), with_conjugate_bit(1, false));
  std::vector<Complex> z(layout.slot_count() + 1, kPeak);
  std::vector<std::uint8_t> receives(layout.slot_count());
  return {std::move(topology), std::move(couplings), std::move(gauge), std::move(z),
          std::move(receives)};
}

void SumScratch::reserve(std::span<const Level> levels) {
  for (std::size_t l = 0; l + 1 < levels.size(); ++l) {
    const SlicedLayout& coarse = levels[l + 1].layout();
    for (Index slice = 0; slice < coarse.slice_count(); ++slice) {
      entries = std::max(entries, std::size_t{coarse.width(slice * kLanes)} * kLanes);
    }
    places = std::max<std::size_t>(places, levels[l].aggregation().sources.places);
    slices = std::max<std::size_t>(slices, coarse.slice_count());
  }
  for (OfThread& own : threads) make_room(own);
  reserve_threads();
}

void SumScratch::reserve_threads() {
  while (threads.size() < thread_capacity()) {
    OfThread own;
    make_room(own);
    threads.push_back(std::move(own));
  }
}

void SumScratch::make_room(OfThread& own) const {
  own.gauged.resize(places);
  own.marked.resize(slices);
  own.reflecting.reserve(entries);
}

Hierarchy finest_level(const Adjacency& adjacency, const Progress& progress) {
  Hierarchy hierarchy;
  Stopwatch watch;
  // Neither task can be split among threads, but both can run concurrently.
  GreedyColorer colorer(adjacency);
  BreadthFirstWalk walk(adjacency);
  constexpr Index kNodesPerTick = 1 << 17;
  const auto count = static_cast<Index>(adjacency.node_count());
  for (Index first = 0; first < count; first += kNodesPerTick) {
    progress.tick();
    const Index last = std::min(count, first + kNodesPerTick);
    parallel_for(
        2,
        [&](std::size_t begin, std::size_t end) {
          for (Index node = first; begin == 0 && node < last; ++node) colorer.color(node);
          for (Index node = first; end == 2 && node < last; ++node) walk.step();
        },
        1);
  }
  auto layout = std::make_shared<SlicedLayout>(
      sliced_layout(adjacency, colorer.take(), walk.take(), {}, progress));
  progress.tick();
  hierarchy.levels.push_back(make_level({std::move(layout), nullptr}));
  hierarchy.topology_milliseconds = watch.lap();
  return hierarchy;
}

void coarsen(Hierarchy& hierarchy, const Progress& whole) {
  const Progress progress = whole.step("hierarchy");
  Stopwatch watch;
  while (hierarchy.levels.back().layout().entry_count() > 0) {
    Level& fine = hierarchy.levels.back();
    const auto finest_size = static_cast<double>(hierarchy.levels[0].z.size());
    const double left = static_cast<double>(fine.z.size()) / finest_size;
    progress.report(1 - left);
    const Aggregates aggregates = grow_aggregates(fine.layout(), fine.couplings, progress);
    if (aggregates.count() == 0) break;
    progress.report(1 - 0.6 * left);
    const Adjacency adjacency = coarse_adjacency(fine.layout(), aggregates);
    progress.tick();
    const Coloring coloring = greedy_coloring(adjacency);
    progress.tick();
    Level coarse = make_level(
        {std::make_shared<SlicedLayout>(coarse_layout(aggregates, adjacency, coloring)), nullptr});
    fine.topology.aggregation = std::make_shared<Aggregation>(
        arrange(fine.layout(), aggregates, adjacency, coarse.layout(), progress));
    progress.tick();
    hierarchy.levels.push_back(std::move(coarse));
    hierarchy.scratch.reserve(hierarchy.levels);
    hierarchy.topology_milliseconds += watch.lap();
    const std::size_t finer = hierarchy.levels.size() - 2;
    renew_gauges(hierarchy.levels[finer]);
    progress.tick();
    renew_sums(hierarchy.levels[finer], hierarchy.levels[finer + 1], hierarchy.scratch);
    hierarchy.numeric_milliseconds += watch.lap();
  }
}

Hierarchy build_hierarchy(const PhaseGraph& graph, const Progress& progress) {
  Hierarchy hierarchy = finest_level(*graph.adjacency, progress.step("hierarchy"));
  Stopwatch watch;
  load_couplings(graph, hierarchy.levels[0].layout(), hierarchy.levels[0].couplings);
  hierarchy.numeric_milliseconds += watch.lap();
  coarsen(hierarchy, progress);
  return hierarchy;
}

Hierarchy sibling(const Hierarchy& hierarchy) {
  Hierarchy result;
  for (const Level& level : hierarchy.levels) {
    result.levels.push_back(make_level(level.topology));
  }
  result.scratch.reserve(result.levels);
  return result;
}

/// Prefetches the couplings of a block in memory order, before gauges read them in their own.
class CouplingFetcher {
 public:
  CouplingFetcher(const Level& level, SliceRange block)
      : next_(at(level, block.begin)), end_(at(level, block.end)) {}

  void fetch(std::ptrdiff_t lines) {
#if defined(__GNUC__)
    constexpr std::ptrdiff_t kLine = 64 / sizeof(float);
    for (const float* const stop = next_ + std::min(lines * kLine, end_ - next_); next_ < stop;
         next_ += kLine) {
      __builtin_prefetch(next_);
    }
#endif
  }
  void fetch_rest() { fetch(end_ - next_); }

 private:
  static const float* at(const Level& level, Index slice) {
    return level.couplings.direct.get() +
           std::size_t{level.layout().column_begin[slice]} * 2 * kLanes;
  }

  const float* next_;
  const float* end_;
};

/// Updates the gauges of one chunk while prefetching the couplings of the next.
void renew_chunk(Level& level, Index chunk, CouplingFetcher next) {
  // Prefetching a block takes about as many steps as its gauges.
  constexpr Index kGroups = 8;
  constexpr std::ptrdiff_t kLines = 160;
  const GaugeSchedule& rounds = level.aggregation().gauges;
  const bool reflecting = reflects(level, level.layout().block(chunk));
  for (const SliceRange& range : rounds.ranges_of(chunk)) {
    for (Index group = range.begin; group < range.end; group += kGroups) {
      renew_groups(level, {group, std::min(group + kGroups, range.end)}, reflecting);
      next.fetch(kLines);
    }
  }
  next.fetch_rest();
}

void renew_gauges(Level& level) {
  parallel_for(
      level.aggregation().gauges.chunk_count(),
      [&](std::size_t begin, std::size_t end) {
        const SlicedLayout& layout = level.layout();
        CouplingFetcher(level, layout.block(static_cast<Index>(begin))).fetch_rest();
        for (Index chunk = static_cast<Index>(begin); chunk < end; ++chunk) {
          const Index after = layout.block_begin[chunk + 1];
          const Index stop = chunk + 1 < end ? layout.block_begin[chunk + 2] : after;
          renew_chunk(level, chunk, CouplingFetcher(level, {after, stop}));
        }
      },
      1);
}

namespace {

/// Updates `count` blocks of `coarse`; `block_of(n)` is the n-th.
template <class BlockOf>
void sum_blocks(const Level& fine, Level& coarse, SumScratch& scratch, std::size_t count,
                const BlockOf& block_of) {
  const bool anchored = !fine.couplings.anchor.empty();
  coarse.couplings.anchor.resize(anchored ? coarse.layout().slot_count() : 0);
  scratch.reserve_threads();
  parallel_for(
      count,
      [&](std::size_t begin, std::size_t end) {
        SumScratch::OfThread& own = scratch.threads.at(thread_number());
        for (std::size_t n = begin; n < end; ++n) {
          const Index block = block_of(n);
          sum_block(fine, coarse, block, own);
          const SliceRange slices = coarse.layout().block(block);
          for (Index slice = slices.begin; anchored && slice < slices.end; ++slice) {
            sum_anchors(fine, coarse, slice);
          }
        }
      },
      1);
}

}  // namespace

void renew_sums(const Level& fine, Level& coarse, SumScratch& scratch) {
  sum_blocks(fine, coarse, scratch, coarse.layout().block_count(),
             [](std::size_t n) { return static_cast<Index>(n); });
}

void renew_sums(const Level& fine, Level& coarse, SumScratch& scratch,
                std::span<const Index> blocks) {
  sum_blocks(fine, coarse, scratch, blocks.size(), [&](std::size_t n) { return blocks[n]; });
}

void reset_gauges(Hierarchy& hierarchy) {
  if (!hierarchy.corrected) return;
  // `renew_gauges` does not change the gauges of first members.
  auto& gauge = hierarchy.levels[0].gauge;
  std::fill(gauge.begin(), gauge.end(), with_conjugate_bit(1, false));
  hierarchy.corrected = false;
}

void renew(Hierarchy& hierarchy) {
  reset_gauges(hierarchy);
  for (std::size_t l = 0; l + 1 < hierarchy.levels.size(); ++l) {
    renew_gauges(hierarchy.levels[l]);
    renew_sums(hierarchy.levels[l], hierarchy.levels[l + 1], hierarchy.scratch);
  }
}

void prolong(const Level& coarse, Level& fine) {
  parallel_for(
      fine.layout().slice_count(),
      [&](std::size_t begin, std::size_t end) {
        kernels::prolong_slices(fine.gauge.data(), fine.aggregation().coarse_slot.data(),
                                coarse.z.data(), fine.z.data(),
                                {static_cast<Index>(begin), static_cast<Index>(end)});
      },
      kSliceGrain);
}

}  // namespace brindle
