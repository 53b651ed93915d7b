#include "brindle/distributed/levels/gathered_rows.h"

#include <algorithm>
#include <cstddef>
#include <numeric>

namespace brindle {
namespace {

/// Where every rank's part begins, and the end.
std::vector<Index> firsts(Communicator& ranks, Index own) {
  std::vector<Index> result = {0};
  for (const Index count : ranks.all(own)) result.push_back(result.back() + count);
  return result;
}

/// The strengths of a graph's edges in the order of the rows.
std::vector<float> strengths_by_entry(const StrengthGraph& graph, const RowLevel& level) {
  std::vector<float> result;
  for (Index node = 0; node < graph.size(); ++node) {
    const auto begin = graph.neighbors.begin() + graph.offsets[node];
    const auto end = graph.neighbors.begin() + graph.offsets[node + 1];
    for (Index e = level.offsets[node]; e < level.offsets[node + 1]; ++e) {
      const auto found = std::find(begin, end, level.columns[e]);
      result.push_back(graph.strengths[static_cast<std::size_t>(found - graph.neighbors.begin())]);
    }
  }
  return result;
}

}  // namespace

GatheredRows::GatheredRows(Communicator& ranks, const StrengthGraph& graph, const NodeHalo& halo,
                           const RowLevel& level)
    : first_node_(firsts(ranks, level.size())),
      first_entry_(firsts(ranks, static_cast<Index>(level.columns.size()))) {
  gather_graph(ranks, graph, halo, level);
}

/// Nodes are numbered rank by rank. Those of the coarsest level have their numbers as places.
void GatheredRows::gather_graph(Communicator& ranks, const StrengthGraph& graph,
                                const NodeHalo& halo, const RowLevel& level) {
  std::vector<Index> number(level.size_with_others());
  std::iota(number.begin(), number.end(), first_node_[static_cast<std::size_t>(ranks.rank())]);
  exchange(ranks, halo, std::span(number));
  std::vector<Index> degrees, columns;
  for (Index node = 0; node < level.size(); ++node) {
    degrees.push_back(level.offsets[node + 1] - level.offsets[node]);
  }
  for (const Index column : level.columns) columns.push_back(number[column]);
  const std::vector<float> strengths = strengths_by_entry(graph, level);
  const auto all_degrees = joined<Index>(ranks.gather(std::as_bytes(std::span(degrees))));
  Adjacency adjacency;
  adjacency.neighbors = joined<Index>(ranks.gather(std::as_bytes(std::span(columns))));
  const auto all_strengths = joined<float>(ranks.gather(std::as_bytes(std::span(strengths))));
  ranks.together([&] {
    if (ranks.rank() != 0) return;
    for (const Index degree : all_degrees) {
      adjacency.offsets.push_back(adjacency.offsets.back() + degree);
    }
    levels_ = std::make_shared<const RowLevels>(row_levels(adjacency, all_strengths));
    multigrid_ = std::make_unique<BoundedMultigrid>(levels_);
    find_entries(adjacency);
    all_.resize(std::max(adjacency.neighbors.size(), adjacency.node_count()));
  });
}

void GatheredRows::find_entries(const Adjacency& adjacency) {
  const RowLevel& rows = levels_->levels[0];
  for (Index node = 0; node < adjacency.node_count(); ++node) {
    const Index row = levels_->place_of[node];
    const auto begin = rows.columns.begin() + rows.offsets[row];
    const auto end = rows.columns.begin() + rows.offsets[row + 1];
    for (const Index other : adjacency.of(node)) {
      const auto found = std::find(begin, end, levels_->place_of[other]);
      entry_of_.push_back(static_cast<Index>(found - rows.columns.begin()));
    }
  }
}

std::span<float> GatheredRows::on_root(std::span<float> (BoundedMultigrid::*part)()) {
  return multigrid_ ? (*multigrid_.*part)() : std::span<float>();
}

/// All ranks' numbers on rank 0, those of rank r from first[r] on; nothing elsewhere.
std::span<const float> GatheredRows::gathered(Communicator& ranks, std::span<const float> own,
                                              std::span<const Index> first) {
  const Outgoing outgoing{0, std::as_bytes(own)};
  std::vector<Incoming> incoming;
  for (int r = 0; ranks.rank() == 0 && r < ranks.size(); ++r) {
    const Index begin = first[static_cast<std::size_t>(r)];
    const Index end = first[static_cast<std::size_t>(r) + 1];
    incoming.push_back({r, std::as_writable_bytes(std::span(all_).subspan(begin, end - begin))});
  }
  ranks.transfer({&outgoing, 1}, incoming);
  return std::span(all_).first(ranks.rank() == 0 ? first.back() : 0);
}

/// All ranks' numbers of nodes where they belong on rank 0.
void GatheredRows::take_nodes(Communicator& ranks, std::span<const float> own,
                              std::span<float> by_place) {
  const std::span<const float> all = gathered(ranks, own, first_node_);
  for (std::size_t node = 0; node < all.size(); ++node) {
    by_place[levels_->place_of[node]] = all[node];
  }
}

void GatheredRows::scatter(Communicator& ranks, std::span<float> own) {
  std::vector<Outgoing> outgoing;
  if (ranks.rank() == 0) {
    const std::span<const float> x = multigrid_->x();
    for (std::size_t node = 0; node < x.size(); ++node) all_[node] = x[levels_->place_of[node]];
    for (int r = 0; r < ranks.size(); ++r) {
      const Index first = first_node_[static_cast<std::size_t>(r)];
      const Index end = first_node_[static_cast<std::size_t>(r) + 1];
      outgoing.push_back({r, std::as_bytes(std::span(all_).subspan(first, end - first))});
    }
  }
  const Incoming incoming{0, std::as_writable_bytes(own)};
  ranks.transfer(outgoing, {&incoming, 1});
}

void GatheredRows::set(Communicator& ranks, const RowMatrix& matrix) {
  const std::span<const float> values = gathered(ranks, matrix.values, first_entry_);
  for (std::size_t e = 0; e < values.size(); ++e) multigrid_->values()[entry_of_[e]] = values[e];
  take_nodes(ranks, matrix.diagonal, on_root(&BoundedMultigrid::diagonal));
  if (multigrid_) multigrid_->prepare_without_bounds();
}

void GatheredRows::solve(Communicator& ranks, std::span<const float> right, int visits,
                         std::span<float> x) {
  take_nodes(ranks, right, on_root(&BoundedMultigrid::right));
  if (multigrid_) multigrid_->solve_without_bounds(visits);
  scatter(ranks, x);
}

void GatheredRows::start(Communicator& ranks, const RowProblem& problem, std::span<float> x) {
  take_nodes(ranks, problem.right, on_root(&BoundedMultigrid::right));
  take_nodes(ranks, problem.lower, on_root(&BoundedMultigrid::lower));
  take_nodes(ranks, problem.upper, on_root(&BoundedMultigrid::upper));
  if (multigrid_) multigrid_->start_as_coarser();
  scatter(ranks, x);
}

}  // namespace brindle
