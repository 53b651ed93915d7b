#include "brindle/distributed/levels/rank_hierarchy.h"

#include <algorithm>
#include <span>
#include <utility>

#include "brindle/phases/multilevel.h"
#include "brindle/phases/node_order.h"
#include "brindle/phases/several_starts.h"

namespace brindle {
namespace {

/// Coarsening that leaves more nodes than this share of them is given up, and the level gathered:
/// the parts are too torn for more.
constexpr double kPoorShare = 0.6;

/// As `finest_level` orders nodes; ghosts come last.
std::vector<Index> own_first(const RankGraph& graph) {
  std::vector<Index> order = breadth_first_order(*graph.adjacency);
  std::erase_if(order, [&](Index node) { return node >= graph.own; });
  for (Index ghost = graph.own; ghost < graph.node_count(); ++ghost) order.push_back(ghost);
  return order;
}

std::vector<Index> finest_blocks(const RankGraph& graph) {
  std::vector<Index> ends = equal_blocks(graph.own);
  if (graph.ghost_count() > 0) ends.push_back(graph.node_count());
  return ends;
}

/// The planned blocks, ghosts with the last of them.
std::vector<Index> planned_blocks(const PlannedLevel& plan, const RankGraph& graph) {
  std::vector<Index> ends = plan.block_end;
  if (ends.empty()) ends.push_back(0);
  ends.back() = graph.node_count();
  return ends;
}

/// Slots that own nodes stand in.
Index own_slots(const SlicedLayout& layout, Index color_count) {
  Index slices = 0;
  for (Index color = 0; color < 2 * color_count; ++color) {
    for (const SliceRange& range : layout.ranges_of(color)) slices += range.end - range.begin;
  }
  return slices * kLanes;
}

}  // namespace

RankHierarchy::RankHierarchy(Communicator& ranks, RankGraph graph, std::size_t gather_below)
    : RankHierarchy(ranks, std::move(graph), {}, {}) {
  gather_below_ = gather_below;
}

RankHierarchy::RankHierarchy(Communicator& ranks, RankGraph graph, std::vector<PlannedLevel> plan,
                             Gathering rest)
    : ranks_(ranks), plan_(std::move(plan)), rest_(std::move(rest)) {
  const Coloring coloring = coloring_of(graph);
  Level level = make_level(
      {std::make_shared<SlicedLayout>(finest_layout(graph, with_sorts(graph, coloring))), nullptr});
  add_level(std::move(graph), std::move(level), coloring);
}

/// Of the next level.
Coloring RankHierarchy::coloring_of(const RankGraph& graph) {
  if (plan_.empty()) return rank_coloring(ranks_, graph);
  const PlannedLevel& planned = plan_[parts_.size()];
  Coloring coloring{planned.color, planned.color_count};
  coloring.color.resize(graph.node_count());
  exchange(ranks_, graph.halo, std::span(coloring.color));
  return coloring;
}

SlicedLayout RankHierarchy::finest_layout(const RankGraph& graph, const Coloring& sorts) const {
  if (plan_.empty()) {
    return sliced_layout(*graph.adjacency, sorts, own_first(graph), finest_blocks(graph));
  }
  return sliced_layout(*graph.adjacency, sorts, {}, planned_blocks(plan_[0], graph));
}

/// Of the level that aggregates make.
SlicedLayout RankHierarchy::layout_of(const RankAggregates& made, const Coloring& sorts) const {
  const Adjacency& adjacency = *made.coarse.adjacency;
  if (plan_.empty()) return coarse_layout(made.aggregates, adjacency, sorts);
  return sliced_layout(adjacency, sorts, {}, planned_blocks(plan_[parts_.size()], made.coarse));
}

void RankHierarchy::add_level(RankGraph graph, Level level, const Coloring& coloring) {
  Part part;
  part.color_count = coloring.color_count;
  part.halo = SlotHalo(graph.halo, level.layout(), coloring, coloring.color_count);
  part.slots_of_all = plan_.empty() ? ranks_.sum(own_slots(level.layout(), coloring.color_count))
                                    : plan_[parts_.size()].slots_of_all;
  part.nodes_of_all = ranks_.sum(std::size_t{graph.own});
  part.graph = std::move(graph);
  parts_.push_back(std::move(part));
  hierarchy_.levels.push_back(std::move(level));
}

bool RankHierarchy::is_small(std::size_t level) const {
  if (ranks_.size() == 1) return false;
  if (!plan_.empty()) return level + 1 == plan_.size();
  const auto nodes = static_cast<double>(parts_[level].nodes_of_all);
  if (parts_[level].nodes_of_all < gather_below_) return true;
  return level > 0 && nodes > kPoorShare * static_cast<double>(parts_[level - 1].nodes_of_all);
}

void RankHierarchy::coarsen(const Progress& progress) {
  is_coarsened_ = true;
  while (ranks_.any(hierarchy_.levels.back().layout().entry_count() > 0)) {
    ranks_.together([&] {
      progress.report("hierarchy", 1 - static_cast<double>(hierarchy_.levels.back().z.size()) /
                                           static_cast<double>(hierarchy_.levels[0].z.size()));
    });
    if (is_small(hierarchy_.levels.size() - 1)) return gather(progress);
    if (!add_coarser()) return;
  }
}

void RankHierarchy::gather(const Progress& progress) {
  const std::size_t last = hierarchy_.levels.size() - 1;
  rest_.is_finest = last == 0;
  gathered_.emplace(ranks_, parts_[last].graph, hierarchy_.levels[last], std::move(rest_),
                    progress);
}

void RankHierarchy::take_gathered(GatheredLevels gathered) {
  gathered_.emplace(std::move(gathered));
  is_coarsened_ = true;
}

/// Returns whether there is anything coarser.
bool RankHierarchy::add_coarser() {
  const std::size_t last = hierarchy_.levels.size() - 1;
  Aggregates own = plan_.empty()
                       ? own_aggregates(ranks_, parts_[last].graph, hierarchy_.levels[last])
                       : planned_aggregates(hierarchy_.levels[last].layout(), plan_[last]);
  if (!ranks_.any(own.count() > 0)) return false;
  RankAggregates made =
      with_ghosts(ranks_, parts_[last].graph, hierarchy_.levels[last], std::move(own));
  if (!plan_.empty()) order_rows(ranks_, plan_[last + 1], made.coarse);
  const Coloring coloring = coloring_of(made.coarse);
  Level coarse = make_level(
      {std::make_shared<SlicedLayout>(layout_of(made, with_sorts(made.coarse, coloring))),
       nullptr});
  Level& fine = hierarchy_.levels[last];
  fine.topology.aggregation = std::make_shared<Aggregation>(
      arrange(fine.layout(), made.aggregates, *made.coarse.adjacency, coarse.layout()));
  set_blocks(parts_[last], fine, coarse);
  add_level(std::move(made.coarse), std::move(coarse), coloring);
  hierarchy_.scratch.reserve(hierarchy_.levels);
  renew_sums_to(last + 1);
  return true;
}

void RankHierarchy::set_blocks(Part& part, const Level& fine, const Level& coarse) const {
  const SlicedLayout& layout = fine.layout();
  const auto is_ghost = [&](Index slot) {
    return layout.node_at[slot] != kNone && layout.node_at[slot] >= part.graph.own;
  };
  for (Index block = 0; block < coarse.layout().block_count(); ++block) {
    const bool needs_ghosts =
        std::ranges::any_of(fine.aggregation().sources.runs_of(block), [&](SliceRange run) {
          const auto first = layout.neighbor.begin() + layout.column_begin[run.begin] * kLanes;
          const auto end = layout.neighbor.begin() + layout.column_begin[run.end] * kLanes;
          return std::any_of(first, end, is_ghost);
        });
    (needs_ghosts ? part.border : part.inner).push_back(block);
  }
}

/// The gauges of the finer level, and the sums of this one; ghosts' gauges are on their way while
/// sums are made that need none.
void RankHierarchy::renew_sums_to(std::size_t coarse) {
  Level& fine = hierarchy_.levels[coarse - 1];
  Part& part = parts_[coarse - 1];
  renew_gauges(fine);
  part.halo.start(ranks_, fine.gauge, 0, part.color_count);
  renew_sums(fine, hierarchy_.levels[coarse], hierarchy_.scratch, part.inner);
  part.halo.finish(ranks_, fine.gauge, 0, part.color_count);
  renew_sums(fine, hierarchy_.levels[coarse], hierarchy_.scratch, part.border);
}

void RankHierarchy::renew() {
  reset_gauges(hierarchy_);
  for (std::size_t l = 1; l < hierarchy_.levels.size(); ++l) renew_sums_to(l);
  if (gathered_) gathered_->renew(ranks_, hierarchy_.levels.back());
}

void RankHierarchy::exchange_phases() { parts_[0].halo.exchange(ranks_, hierarchy_.levels[0].z); }

/// Calls `update(color)` for the slots of one colour after the other, first for those at the
/// border: what they have become is on its way while the others' turn is.
template <class Update>
void RankHierarchy::for_each_color(std::size_t level, std::span<Complex> z, const Update& update) {
  Part& part = parts_[level];
  for (Index color = 0; color < part.color_count; ++color) {
    update(part.color_count + color);
    part.halo.start(ranks_, z, color, color + 1);
    update(color);
    part.halo.finish(ranks_, z, color, color + 1);
  }
}

void RankHierarchy::sweep_level(std::size_t level, SweepPlan plan) {
  Level& swept = hierarchy_.levels[level];
  const LevelSweeps planned = plan.on_level(parts_[level].slots_of_all);
  for (int number = 0; number < planned.count; ++number) {
    for_each_color(level, swept.z, [&](Index color) {
      sweep_color(swept.layout(), swept.couplings, swept.z, planned.over_relaxation_of(number),
                  color);
    });
  }
}

/// Below what is gathered, whose phases the last level has.
void RankHierarchy::descend_from(Complex start, SweepPlan plan) {
  auto& levels = hierarchy_.levels;
  if (gathered_) {
    parts_.back().halo.exchange(ranks_, levels.back().z);
  } else {
    std::ranges::fill(levels.back().z, start);
    sweep_level(levels.size() - 1, plan);
  }
  for (std::size_t l = levels.size() - 1; l-- > 0;) {
    prolong(levels[l + 1], levels[l]);
    sweep_level(l, plan);
  }
}

void RankHierarchy::descend(SweepPlan plan) {
  if (gathered_) {
    gathered_->descend(ranks_, parts_.back().graph, hierarchy_.levels.back(),
                       [&](Hierarchy& rest) { brindle::descend(rest, plan); });
  }
  descend_from(kPeak, plan);
}

EnergySums RankHierarchy::lowered() const {
  return ranks_.sum(lowered_sums(hierarchy_.levels[0], hierarchy_.levels[0].z));
}

bool RankHierarchy::descend_from_several(int sweeps) {
  if (!gathered_) return brindle::descend_from_several(hierarchy_, sweeps);
  Level& last = hierarchy_.levels.back();
  const RankGraph& graph = parts_.back().graph;
  if (hierarchy_.levels.size() == 1) {
    bool is_lower = false;
    gathered_->descend(ranks_, graph, last, [&](Hierarchy& whole) {
      is_lower = brindle::descend_from_several(whole, sweeps);
    });
    descend_from(kPeak, sweeps);
    return ranks_.any(is_lower);
  }
  std::vector<Complex>& z = hierarchy_.levels[0].z;
  descend(sweeps);
  const EnergySums plain_sums = lowered();
  std::vector<Complex> plain = z;
  gathered_->descend(ranks_, graph, last,
                     [&](Hierarchy& rest) { descend_from_lowest(rest, sweeps); });
  descend_from(kPeak, sweeps);
  const bool is_lower = is_much_lower(lowered(), plain_sums);
  if (!is_lower) z = std::move(plain);
  return is_lower;
}

void RankHierarchy::start_from(std::span<const Complex> z, int sweeps) {
  Level& finest = hierarchy_.levels[0];
  to_slots(finest.layout(), z, finest.z);
  sweep_level(0, sweeps);
}

void RankHierarchy::begin_with(std::span<const Complex> z) {
  Level& finest = hierarchy_.levels[0];
  to_slots(finest.layout(), z, finest.z);
  if (gathered_ && hierarchy_.levels.size() == 1) {
    gathered_->take_phases(ranks_, parts_[0].graph, finest);
  }
}

/// As `correct` of phases/multilevel.h. Ghosts have the phases and gauges of their owners already.
void RankHierarchy::correct(SweepPlan plan) {
  hierarchy_.corrected = true;
  for (std::size_t l = 0; l + 1 < hierarchy_.levels.size(); ++l) {
    set_turns(hierarchy_.levels[l], l == 0);
    renew_sums(hierarchy_.levels[l], hierarchy_.levels[l + 1], hierarchy_.scratch);
  }
  if (gathered_) {
    gathered_->correct(ranks_, parts_.back().graph, plan, hierarchy_.levels.back());
  }
  descend_from(Complex(1), plan);
}

void RankHierarchy::run_cycles(SweepPlan plan, int cycles, const Progress& progress) {
  for (int cycle = 0; cycle < cycles; ++cycle) {
    ranks_.together([&] { progress.report("cycles", static_cast<double>(cycle) / cycles); });
    correct(plan);
  }
}

void RankHierarchy::relax(Momentum& momentum) {
  Level& level = hierarchy_.levels[0];
  for_each_color(0, level.z, [&](Index color) {
    relax_color(level.layout(), level.couplings, level.z, momentum, color);
  });
}

std::size_t RankHierarchy::halo_bytes(int sweeps) const {
  std::size_t bytes = 0;
  for (std::size_t l = 0; l < distributed_levels(); ++l) {
    const auto count =
        static_cast<std::size_t>(SweepPlan(sweeps).on_level(parts_[l].slots_of_all).count);
    bytes += sizeof(Complex) * parts_[l].halo.ghost_count() * count;
  }
  return bytes;
}

double RankHierarchy::energy() const {
  const Level& level = hierarchy_.levels[0];
  return ranks_.sum(energy_sums(level.layout(), level.couplings, level.z)).relative();
}

}  // namespace brindle
