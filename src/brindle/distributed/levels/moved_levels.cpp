#include "brindle/distributed/levels/moved_levels.h"

#include <utility>

namespace brindle {

MovedLevels::MovedLevels(Communicator& ranks, const RankGraph& source, LevelPlan plan,
                         Gathering rest)
    : MovedLevels(ranks, source, plan, graph_of(plan, ranks), std::move(rest)) {}

MovedLevels::MovedLevels(Communicator& ranks, const RankGraph& source, const LevelPlan& plan,
                         PlannedGraph planned, Gathering rest)
    : ranks_(ranks),
      levels_(ranks, std::move(planned.graph), plan.levels, std::move(rest)),
      own_(static_cast<std::size_t>(ranks.size())),
      places_(own_.size()) {
  take_places(plan, planned.neighbor);
  std::vector<std::vector<Index>> asked(own_.size());
  for (std::size_t node = 0; node < plan.source_node.size(); ++node) {
    asked[plan.source_rank[node]].push_back(plan.source_node[node]);
  }
  sent_ = ranks.swap_lists(asked);
  for (const std::vector<Index>& nodes : sent_) packers_.emplace_back(source.adjacency, nodes);
  packed_.resize(packers_.size());
}

void MovedLevels::take_places(const LevelPlan& plan, const std::vector<Index>& neighbor) {
  const SlicedLayout& layout = levels_.finest().layout();
  std::vector<Index> slots;
  for (Index node = 0; node < plan.source_rank.size(); ++node) {
    slots.clear();
    for (Index e = plan.row_begin[node]; e < plan.row_begin[node + 1]; ++e) {
      slots.push_back(layout.slot_of[neighbor[e]]);
    }
    places_[plan.source_rank[node]].add(layout, layout.slot_of[node], slots);
    own_[plan.source_rank[node]].push_back(node);
  }
}

void MovedLevels::load(const Level& source) {
  const auto here = static_cast<std::size_t>(ranks_.rank());
  for (std::size_t r = 0; r < packers_.size(); ++r) {
    packed_[r].clear();
    if (r != here && !sent_[r].empty()) packers_[r].pack(source, packed_[r]);
  }
  Level& finest = levels_.finest();
  const LocalRows local{source, packers_[here], places_[here]};
  load_rows(ranks_.swap_lists(packed_), places_, finest.layout(), finest.couplings, &local);
}

void MovedLevels::take_phases(const Level& source) {
  std::vector<std::vector<Complex>> phases(sent_.size());
  for (std::size_t r = 0; r < sent_.size(); ++r) {
    for (const Index node : sent_[r]) phases[r].push_back(source.z[source.layout().slot_of[node]]);
  }
  const auto theirs = ranks_.swap_lists(phases);
  Level& finest = levels_.finest();
  for (std::size_t r = 0; r < own_.size(); ++r) {
    for (std::size_t n = 0; n < own_[r].size(); ++n) {
      finest.z[finest.layout().slot_of[own_[r][n]]] = theirs[r][n];
    }
  }
  levels_.exchange_phases();
}

void MovedLevels::bring_back(Level& source) {
  const Level& finest = levels_.finest();
  std::vector<std::vector<Complex>> phases(own_.size());
  for (std::size_t r = 0; r < own_.size(); ++r) {
    for (const Index node : own_[r]) phases[r].push_back(finest.z[finest.layout().slot_of[node]]);
  }
  const auto theirs = ranks_.swap_lists(phases);
  for (std::size_t r = 0; r < sent_.size(); ++r) {
    for (std::size_t n = 0; n < sent_[r].size(); ++n) {
      source.z[source.layout().slot_of[sent_[r][n]]] = theirs[r][n];
    }
  }
}

}  // namespace brindle
