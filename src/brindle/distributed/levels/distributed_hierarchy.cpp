#include "brindle/distributed/levels/distributed_hierarchy.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace brindle {

DistributedHierarchy::DistributedHierarchy(Communicator& ranks, RankGraph graph,
                                           std::vector<std::uint64_t> ids, HierarchyBounds bounds)
    : ranks_(ranks),
      bounds_(bounds),
      ids_(std::move(ids)),
      levels_(ranks, std::move(graph), bounds.gather_below) {}

/// The first one that is small, or the last.
std::size_t DistributedHierarchy::gathered_level(const Hierarchy& whole) const {
  std::size_t level = 0;
  while (level + 1 < whole.levels.size() &&
         whole.levels[level].layout().slot_of.size() >= bounds_.gather_below) {
    ++level;
  }
  return level;
}

void DistributedHierarchy::coarsen(const Progress& progress) {
  const std::size_t nodes = ranks_.sum(std::size_t{levels_.graph().own});
  if (ranks_.size() == 1 || nodes >= bounds_.planned_below()) return levels_.coarsen(progress);
  GatheredLevels whole(ranks_, levels_.graph(), finest(), {true, numbers_by_id(ranks_, ids_), {}},
                       progress);
  const std::size_t last =
      ranks_.greatest(ranks_.rank() == 0 ? gathered_level(whole.hierarchy()) : 0);
  if (last == 0) return levels_.take_gathered(std::move(whole));
  CutLevels cut;
  Gathering rest;
  ranks_.together([&] {
    if (ranks_.rank() != 0) return;
    cut = cut_levels(whole.hierarchy(), last, whole.places());
    rest.number_of = std::move(cut.number_of);
    std::vector<Level>& levels = whole.hierarchy().levels;
    std::move(levels.begin() + static_cast<std::ptrdiff_t>(last), levels.end(),
              std::back_inserter(rest.hierarchy.levels));
    rest.hierarchy.scratch.reserve(rest.hierarchy.levels);
  });
  moved_.emplace(ranks_, levels_.graph(), scatter_plans(ranks_, cut.plans), std::move(rest));
  moved_->load(finest());
  moved_->levels().coarsen(progress);
}

void DistributedHierarchy::renew() {
  if (!moved_) return levels_.renew();
  moved_->load(finest());
  moved_->levels().renew();
}

void DistributedHierarchy::bring_back() {
  moved_->bring_back(levels_.finest());
  levels_.exchange_phases();
}

void DistributedHierarchy::descend(SweepPlan plan) {
  if (!moved_) return levels_.descend(plan);
  moved_->levels().descend(plan);
  bring_back();
}

bool DistributedHierarchy::descend_from_several(int sweeps) {
  if (!moved_) return levels_.descend_from_several(sweeps);
  const bool is_lower = moved_->levels().descend_from_several(sweeps);
  bring_back();
  return is_lower;
}

void DistributedHierarchy::begin_with(std::span<const Complex> z) {
  levels_.begin_with(z);
  if (moved_) moved_->take_phases(levels_.finest());
}

void DistributedHierarchy::run_cycles(SweepPlan plan, int cycles, const Progress& progress) {
  if (!moved_) return levels_.run_cycles(plan, cycles, progress);
  moved_->levels().run_cycles(plan, cycles, progress);
  bring_back();
}

}  // namespace brindle
