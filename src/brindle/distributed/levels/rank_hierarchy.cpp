#include "brindle/distributed/levels/rank_hierarchy.h"

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <span>
#include <utility>

#include "brindle/error.h"
#include "brindle/phases/coloring.h"
#include "brindle/phases/multilevel.h"

namespace brindle {
namespace {

/// The entry of a neighbour in a row of the layout.
Index entry_of(const SlicedLayout& layout, Index row_slot, Index neighbor_slot) {
  std::size_t entry = layout.first_entry(row_slot);
  const std::size_t end = entry + std::size_t{layout.width(row_slot)} * kLanes;
  while (entry < end && layout.neighbor[entry] != neighbor_slot) entry += kLanes;
  if (entry >= end) throw Error("distributed levels: two ranks do not have the same edges");
  return static_cast<Index>(entry);
}

}  // namespace

GatheredLevels::GatheredLevels(Communicator& ranks, const RankGraph& graph, const Level& level,
                               const Progress& progress)
    : adjacency_(graph.adjacency),
      nodes_(ranks, graph.own),
      edges_(ranks, graph.adjacency->neighbors.size()),
      own_z_(graph.own) {
  lay_out(ranks, graph);
  gather_couplings(ranks, level);
  ranks.on_first(progress, [&](const Progress& heard) { coarsen(hierarchy_, heard); });
}

void GatheredLevels::lay_out(Communicator& ranks, const RankGraph& graph) {
  std::vector<Index> number(graph.node_count());
  std::iota(number.begin(), number.end(), nodes_.first(ranks.rank()));
  exchange(ranks, graph.halo, std::span(number));
  std::vector<Index> degrees, neighbors, all_degrees, all_neighbors;
  for (Index node = 0; node < graph.own; ++node) {
    degrees.push_back(static_cast<Index>(adjacency_->of(node).size()));
    for (const Index other : adjacency_->of(node)) neighbors.push_back(number[other]);
  }
  nodes_.gather(std::span<const Index>(degrees), all_degrees);
  edges_.gather(std::span<const Index>(neighbors), all_neighbors);
  ranks.throw_on_all([&] {
    if (ranks.rank() == 0) add_entries(all_degrees, all_neighbors);
  });
}

void GatheredLevels::add_entries(std::span<const Index> degrees, std::span<const Index> neighbors) {
  Adjacency sorted;
  sorted.neighbors.assign(neighbors.begin(), neighbors.end());
  for (const Index degree : degrees) {
    const auto row = sorted.neighbors.begin() + sorted.offsets.back();
    std::sort(row, row + degree);
    sorted.offsets.push_back(sorted.offsets.back() + degree);
  }
  hierarchy_ = finest_level(sorted);
  const SlicedLayout& layout = hierarchy_.levels[0].layout();
  for (Index node = 0; node < degrees.size(); ++node) {
    for (Index e = sorted.offsets[node]; e < sorted.offsets[node + 1]; ++e) {
      entry_of_.push_back(entry_of(layout, layout.slot_of[node], layout.slot_of[neighbors[e]]));
    }
  }
}

void GatheredLevels::gather_couplings(Communicator& ranks, const Level& level) {
  const SlicedLayout& layout = level.layout();
  const SlicedCouplings& couplings = level.couplings;
  const bool anchored = ranks.any(!couplings.anchor.empty());
  const auto own = static_cast<Index>(own_z_.size());
  std::vector<Complex> direct, anchors, all_direct, all_anchors;
  for (Index node = 0; node < own; ++node) {
    const Index slot = layout.slot_of[node];
    std::size_t entry = layout.first_entry(slot);
    for (std::size_t k = 0; k < adjacency_->of(node).size(); ++k, entry += kLanes) {
      direct.push_back(couplings.direct_at(entry));
    }
    anchors.push_back(couplings.anchor.empty() ? Complex(0) : couplings.anchor[slot]);
  }
  std::vector<ReflectingCoupling> reflecting, all_reflecting;  // by edge
  for (Index slice = 0; slice < layout.slice_count(); ++slice) {
    for (const auto& [entry, b] : couplings.reflecting_of(layout, slice)) {
      const Index node = layout.node_at[slice * kLanes + entry % kLanes];
      if (node >= own) continue;
      const Index edge = adjacency_->offsets[node] + entry / kLanes - layout.column_begin[slice];
      reflecting.push_back({edges_.first(ranks.rank()) + edge, b});
    }
  }
  edges_.gather(std::span<const Complex>(direct), all_direct);
  if (anchored) nodes_.gather(std::span<const Complex>(anchors), all_anchors);
  PartsOnFirst(ranks, reflecting.size())
      .gather(std::span<const ReflectingCoupling>(reflecting), all_reflecting);
  if (ranks.rank() == 0) load_first(all_direct, all_anchors, std::move(all_reflecting));
}

/// `reflecting` has the numbers of edges for those of entries.
void GatheredLevels::load_first(std::span<const Complex> direct, std::span<const Complex> anchors,
                                std::vector<ReflectingCoupling> reflecting) {
  const SlicedLayout& layout = hierarchy_.levels[0].layout();
  SlicedCouplings& couplings = hierarchy_.levels[0].couplings;
  for (std::size_t e = 0; e < direct.size(); ++e) couplings.set_direct(entry_of_[e], direct[e]);
  couplings.anchor.assign(anchors.empty() ? 0 : layout.slot_count(), Complex(0));
  for (std::size_t n = 0; n < anchors.size(); ++n) {
    couplings.anchor[layout.slot_of[n]] = anchors[n];
  }
  for (ReflectingCoupling& coupling : reflecting) coupling.entry = entry_of_[coupling.entry];
  std::ranges::sort(reflecting, {}, &ReflectingCoupling::entry);
  std::ranges::fill(couplings.reflecting_count, Index{0});
  Index slice = 0;
  for (const ReflectingCoupling& coupling : reflecting) {
    while (coupling.entry >= std::size_t{layout.column_begin[slice + 1]} * kLanes) ++slice;
    couplings.append_reflecting(layout, slice, coupling);
  }
}

void GatheredLevels::scatter(Level& level) {
  if (!hierarchy_.levels.empty()) {
    const Level& first = hierarchy_.levels[0];
    z_.resize(nodes_.count());
    for (Index node = 0; node < z_.size(); ++node) z_[node] = first.z[first.layout().slot_of[node]];
  }
  nodes_.scatter(std::span<const Complex>(z_), std::span(own_z_));
  to_slots(level.layout(), own_z_, level.z);
}

void GatheredLevels::renew(Communicator& ranks, const Level& level) {
  gather_couplings(ranks, level);
  if (ranks.rank() == 0) brindle::renew(hierarchy_);
}

void GatheredLevels::descend(Communicator& ranks, SweepPlan plan, Level& level) {
  if (ranks.rank() == 0) brindle::descend(hierarchy_, plan);
  scatter(level);
}

void GatheredLevels::correct(Communicator& ranks, SweepPlan plan, Level& level) {
  gather_couplings(ranks, level);
  if (ranks.rank() == 0) brindle::correct(hierarchy_, plan, false);
  scatter(level);
}

namespace {

/// If coarsening leaves more than this share of nodes, the level is gathered instead: its parts are
/// too fragmented.
constexpr double kPoorShare = 0.6;

/// As `finest_level` orders nodes, with ghosts last.
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

/// The number of slots of own nodes.
Index own_slots(const SlicedLayout& layout, Index color_count) {
  Index slices = 0;
  for (Index color = 0; color < 2 * color_count; ++color) {
    for (const SliceRange& range : layout.ranges_of(color)) slices += range.end - range.begin;
  }
  return slices * kLanes;
}

/// Aggregates, and their graph.
struct RankAggregates {
  Aggregates aggregates;  ///< of own nodes, then of ghosts, from their owners
  RankGraph coarse;
};

bool has_coupling(const Level& level, Index slot) {
  std::size_t entry = level.layout().first_entry(slot);
  for (Index k = 0; k < level.layout().width(slot); ++k, entry += kLanes) {
    if (level.couplings.direct_at(entry) != Complex(0)) return true;
    if (level.couplings.reflecting_at(level.layout(), slot / kLanes, entry) != Complex(0)) {
      return true;
    }
  }
  return false;
}

/// Appends aggregates of ghosts; `of_ghost` has their numbers, after the own ones.
void append_ghosts(const RankGraph& graph, const SlicedLayout& layout,
                   std::span<const Index> of_ghost, Index count, Aggregates& aggregates) {
  const Index own = aggregates.count();
  std::vector<std::vector<Index>> members(count);
  for (Index g = 0; g < of_ghost.size(); ++g) {
    if (of_ghost[g] == kNone) continue;
    const Index slot = layout.slot_of[graph.own + g];
    aggregates.aggregate[slot] = of_ghost[g];
    members[of_ghost[g] - own].push_back(slot);
  }
  for (const std::vector<Index>& slots : members) {
    aggregates.member.insert(aggregates.member.end(), slots.begin(), slots.end());
    aggregates.begin.push_back(static_cast<Index>(aggregates.member.size()));
  }
  aggregates.block_begin.back() = aggregates.count();
}

/// The own aggregates of a level: `grow_aggregates` and, with several ranks, one per node whose
/// neighbours are all ghosts. Ignores couplings of ghosts.
Aggregates own_aggregates(const Communicator& ranks, const RankGraph& graph, const Level& level) {
  Aggregates aggregates = grow_aggregates(level.layout(), level.couplings);
  if (ranks.size() == 1) return aggregates;
  for (Index node = 0; node < graph.own; ++node) {
    const Index slot = level.layout().slot_of[node];
    if (aggregates.aggregate[slot] != kNone || !has_coupling(level, slot)) continue;
    aggregates.aggregate[slot] = aggregates.count();
    aggregates.member.push_back(slot);
    aggregates.begin.push_back(static_cast<Index>(aggregates.member.size()));
  }
  aggregates.block_begin.back() = aggregates.count();
  return aggregates;
}

/// Completes own aggregates by the ghosts', so that couplings between ranks are summed like all
/// others.
RankAggregates with_ghosts(Communicator& ranks, const RankGraph& graph, const Level& level,
                           Aggregates own) {
  const SlicedLayout& layout = level.layout();
  std::vector<Index> aggregate(graph.node_count());
  for (Index node = 0; node < graph.own; ++node) {
    aggregate[node] = own.aggregate[layout.slot_of[node]];
  }

  RankAggregates result;
  result.coarse.own = own.count();
  result.coarse.halo = halo_of_groups(ranks, graph.halo, own.count(), aggregate);
  const auto of_ghost = std::span<const Index>(aggregate).subspan(graph.own);
  Index ghosts = 0;
  for (const HaloNeighbor& neighbor : result.coarse.halo) ghosts += neighbor.count;
  result.aggregates = std::move(own);
  append_ghosts(graph, layout, of_ghost, ghosts, result.aggregates);
  result.coarse.adjacency =
      std::make_shared<const Adjacency>(coarse_adjacency(layout, result.aggregates));
  return result;
}

}  // namespace

RankHierarchy::RankHierarchy(Communicator& ranks, RankGraph graph, std::size_t gather_below)
    : ranks_(ranks), gather_below_(gather_below) {
  const Coloring coloring = rank_coloring(ranks, graph);
  Level level = make_level(
      {std::make_shared<SlicedLayout>(sliced_layout(*graph.adjacency, with_sorts(graph, coloring),
                                                    own_first(graph), finest_blocks(graph))),
       nullptr});
  add_level(std::move(graph), std::move(level), coloring);
}

void RankHierarchy::add_level(RankGraph graph, Level level, const Coloring& coloring) {
  Part part;
  part.color_count = coloring.color_count;
  part.halo = SlotHalo(graph.halo, level.layout(), coloring, coloring.color_count);
  part.slots_of_all = ranks_.sum(own_slots(level.layout(), coloring.color_count));
  part.nodes_of_all = ranks_.sum(std::size_t{graph.own});
  part.graph = std::move(graph);
  parts_.push_back(std::move(part));
  hierarchy_.levels.push_back(std::move(level));
}

/// Whether a level below the finest is small enough for rank 0.
bool RankHierarchy::is_small(std::size_t level) const {
  if (ranks_.size() == 1 || level == 0) return false;
  const auto nodes = static_cast<double>(parts_[level].nodes_of_all);
  return parts_[level].nodes_of_all < gather_below_ ||
         nodes > kPoorShare * static_cast<double>(parts_[level - 1].nodes_of_all);
}

void RankHierarchy::coarsen(const Progress& progress) {
  is_coarsened_ = true;
  while (ranks_.any(hierarchy_.levels.back().layout().entry_count() > 0)) {
    ranks_.throw_on_all([&] {
      progress.report("hierarchy", 1 - static_cast<double>(hierarchy_.levels.back().z.size()) /
                                           static_cast<double>(hierarchy_.levels[0].z.size()));
    });
    if (is_small(hierarchy_.levels.size() - 1)) {
      gathered_.emplace(ranks_, parts_.back().graph, hierarchy_.levels.back(), progress);
      return;
    }
    if (!add_coarser()) return;
  }
}

/// Returns whether there is a coarser level.
bool RankHierarchy::add_coarser() {
  const std::size_t last = hierarchy_.levels.size() - 1;
  Aggregates own = own_aggregates(ranks_, parts_[last].graph, hierarchy_.levels[last]);
  if (!ranks_.any(own.count() > 0)) return false;
  RankAggregates made =
      with_ghosts(ranks_, parts_[last].graph, hierarchy_.levels[last], std::move(own));
  const Coloring coloring = rank_coloring(ranks_, made.coarse);
  Level coarse =
      make_level({std::make_shared<SlicedLayout>(coarse_layout(
                      made.aggregates, *made.coarse.adjacency, with_sorts(made.coarse, coloring))),
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

/// Computes the gauges of the finer level and the sums of this one; sums that need no ghosts'
/// gauges overlap with their exchange.
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

/// Calls `update(color)` for one colour after the other, border nodes first, so that their exchange
/// overlaps with the rest.
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

/// Below the gathered levels, whose phases the last level has.
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

void RankHierarchy::descend(SweepPlan plan, const Progress&) {
  if (gathered_) {
    gathered_->descend(ranks_, plan, hierarchy_.levels.back());
  }
  descend_from(kPeak, plan);
}

/// As `correct` of phases/multilevel.h. Ghosts already have their owners' phases and gauges.
void RankHierarchy::correct(SweepPlan plan) {
  hierarchy_.corrected = true;
  for (std::size_t l = 0; l + 1 < hierarchy_.levels.size(); ++l) {
    set_turns(hierarchy_.levels[l], l == 0);
    renew_sums(hierarchy_.levels[l], hierarchy_.levels[l + 1], hierarchy_.scratch);
  }
  if (gathered_) gathered_->correct(ranks_, plan, hierarchy_.levels.back());
  descend_from(Complex(1), plan);
}

void RankHierarchy::run_cycles(SweepPlan plan, int cycles, const Progress& progress) {
  for (int cycle = 0; cycle < cycles; ++cycle) {
    ranks_.throw_on_all([&] { progress.report("cycles", static_cast<double>(cycle) / cycles); });
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
