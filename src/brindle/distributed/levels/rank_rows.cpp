#include "brindle/distributed/levels/rank_rows.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>

namespace brindle {
namespace {

/// Coarsening stops if a level leaves more than this share of nodes: its parts are too fragmented.
constexpr double kPoorMerge = 0.6;

constexpr std::size_t kSummedAtOnce = 5;

}  // namespace

RankRows::RankRows(Communicator& ranks, const RankGraph& graph, std::size_t gather_below)
    : ranks_(ranks), graph_(graph), gather_below_(gather_below) {
  const std::vector<Index> own = ranks.all(graph.own);
  const auto first = std::ranges::find_if(own, [](Index count) { return count > 0; });
  has_first_node_ = first - own.begin() == ranks.rank();
}

RowLevels RankRows::make_levels(const Adjacency& adjacency, std::span<const float> strengths) {
  const auto own_end = adjacency.offsets.begin() + graph_.own + 1;
  RowLevelMaker maker({{adjacency.offsets.begin(), own_end},
                       adjacency.neighbors,
                       {strengths.begin(), strengths.end()},
                       graph_.ghost_count()});
  std::vector<NodeHalo> halos = {graph_.halo};
  std::size_t nodes = ranks_.sum(std::size_t{graph_.own});
  for (bool is_last = false; !is_last;) {
    Grouping grouping = maker.grouped();
    halos.push_back(halo_of_groups(ranks_, halos.back(), grouping.count, grouping.parent));
    for (const HaloNeighbor& neighbor : halos.back()) grouping.others += neighbor.count;
    const std::size_t before = std::exchange(nodes, ranks_.sum(std::size_t{grouping.count}));
    maker.merge(std::move(grouping));
    is_last = nodes < gather_below_ || nodes <= kFewestNodes ||
              static_cast<double>(nodes) > kPoorMerge * static_cast<double>(before);
  }
  RowLevels levels = maker.made();
  parts_.clear();
  for (std::size_t l = 0; l < levels.levels.size(); ++l) {
    parts_.push_back(make_part(halos[l], maker.places_of(l), levels.levels[l].block_count()));
  }
  gathered_.emplace(ranks_, maker.coarsest(), halos.back(), levels.levels.back());
  return levels;
}

RankRows::Part RankRows::make_part(const NodeHalo& halo, std::span<const Index> place_of,
                                   Index block_count) const {
  Part part;
  std::vector<std::uint8_t> is_border(block_count);
  for (const HaloNeighbor& other : halo) {
    Neighbor neighbor{other.rank, {}, {}, other.first, other.count};
    for (const Index node : other.sent) {
      neighbor.sent.push_back(place_of[node]);
      is_border[place_of[node] / kRowBlock] = 1;
    }
    neighbor.out.resize(neighbor.sent.size());
    part.neighbors.push_back(std::move(neighbor));
  }
  for (Index block = 0; block < block_count; ++block) {
    (is_border[block] ? part.border : part.inner).push_back(block);
  }
  return part;
}

std::span<const Index> RankRows::border_blocks(std::size_t level) const {
  return parts_[level].border;
}

std::span<const Index> RankRows::inner_blocks(std::size_t level) const {
  return parts_[level].inner;
}

void RankRows::start(std::size_t level, std::span<float> by_place) {
  outgoing_.clear();
  incoming_.clear();
  for (Neighbor& neighbor : parts_[level].neighbors) {
    for (std::size_t n = 0; n < neighbor.sent.size(); ++n) {
      neighbor.out[n] = by_place[neighbor.sent[n]];
    }
    const auto ghosts = std::as_writable_bytes(by_place.subspan(neighbor.first, neighbor.count));
    outgoing_.push_back({neighbor.rank, std::as_bytes(std::span(neighbor.out))});
    incoming_.push_back({neighbor.rank, ghosts});
    halo_bytes_ += ghosts.size();
  }
  ranks_.start(outgoing_, incoming_);
}

void RankRows::sum(std::span<double> values) {
  while (!values.empty()) {
    std::array<double, kSummedAtOnce> own{};
    const std::size_t count = std::min(values.size(), own.size());
    std::copy_n(values.begin(), count, own.begin());
    std::array<double, kSummedAtOnce> total{};
    for (const auto& part : ranks_.all(own)) {
      for (std::size_t k = 0; k < count; ++k) total[k] += part[k];
    }
    std::copy_n(total.begin(), count, values.begin());
    values = values.subspan(count);
  }
}

double RankRows::least(double value) { return -ranks_.greatest(-value); }

void RankRows::set_coarsest(const RowMatrix& matrix) { gathered_->set(matrix); }

/// Ranks receive own nodes' values from rank 0; ghosts' are exchanged afterwards.
void RankRows::take_others(std::span<float> coarsest) {
  start(parts_.size() - 1, coarsest);
  finish();
}

void RankRows::solve_coarsest(std::span<const float> right, int visits, std::span<float> x) {
  gathered_->solve(right, visits, x.first(right.size()));
  take_others(x);
}

void RankRows::start_coarsest(const RowProblem& problem, std::span<float> x) {
  const std::size_t own = problem.right.size();
  const RowProblem of_own{problem.right, problem.lower.first(own), problem.upper.first(own)};
  gathered_->start(of_own, x.first(own));
  take_others(x);
}

}  // namespace brindle
