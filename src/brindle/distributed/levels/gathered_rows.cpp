#include "brindle/distributed/levels/gathered_rows.h"

#include <algorithm>
#include <cstddef>
#include <numeric>

namespace brindle {
namespace {

/// The strengths of a graph's edges, in row order.
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
    : nodes_(ranks, level.size()), entries_(ranks, level.columns.size()) {
  gather_graph(ranks, graph, halo, level);
}

/// Nodes are numbered rank by rank. Nodes of the coarsest level are their own places.
void GatheredRows::gather_graph(Communicator& ranks, const StrengthGraph& graph,
                                const NodeHalo& halo, const RowLevel& level) {
  std::vector<Index> number(level.size_with_others());
  std::iota(number.begin(), number.end(), nodes_.first(ranks.rank()));
  exchange(ranks, halo, std::span(number));
  std::vector<Index> degrees, columns;
  for (Index node = 0; node < level.size(); ++node) {
    degrees.push_back(level.offsets[node + 1] - level.offsets[node]);
  }
  for (const Index column : level.columns) columns.push_back(number[column]);
  const std::vector<float> strengths = strengths_by_entry(graph, level);
  std::vector<Index> all_degrees;
  std::vector<float> all_strengths;
  Adjacency adjacency;
  nodes_.gather(std::span<const Index>(degrees), all_degrees);
  entries_.gather(std::span<const Index>(columns), adjacency.neighbors);
  entries_.gather(std::span<const float>(strengths), all_strengths);
  ranks.throw_on_all([&] {
    if (ranks.rank() != 0) return;
    for (const Index degree : all_degrees) {
      adjacency.offsets.push_back(adjacency.offsets.back() + degree);
    }
    levels_ = std::make_shared<const RowLevels>(row_levels(adjacency, all_strengths));
    multigrid_ = std::make_unique<BoundedMultigrid>(levels_);
    find_entries(adjacency);
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

/// Permutes all ranks' node values to rank 0's order.
void GatheredRows::take_nodes(std::span<const float> own, std::span<float> by_place) {
  nodes_.gather(own, all_);
  for (std::size_t node = 0; node < all_.size(); ++node) {
    by_place[levels_->place_of[node]] = all_[node];
  }
}

void GatheredRows::scatter(std::span<float> own) {
  if (multigrid_) {
    const std::span<const float> x = multigrid_->x();
    all_.resize(x.size());
    for (std::size_t node = 0; node < x.size(); ++node) all_[node] = x[levels_->place_of[node]];
  }
  nodes_.scatter(std::span<const float>(all_), own);
}

void GatheredRows::set(const RowMatrix& matrix) {
  entries_.gather(std::span<const float>(matrix.values), all_);
  for (std::size_t e = 0; e < all_.size(); ++e) multigrid_->values()[entry_of_[e]] = all_[e];
  take_nodes(matrix.diagonal, on_root(&BoundedMultigrid::diagonal));
  if (multigrid_) multigrid_->prepare_without_bounds();
}

void GatheredRows::solve(std::span<const float> right, int visits, std::span<float> x) {
  take_nodes(right, on_root(&BoundedMultigrid::right));
  if (multigrid_) multigrid_->solve_without_bounds(visits);
  scatter(x);
}

void GatheredRows::start(const RowProblem& problem, std::span<float> x) {
  take_nodes(problem.right, on_root(&BoundedMultigrid::right));
  take_nodes(problem.lower, on_root(&BoundedMultigrid::lower));
  take_nodes(problem.upper, on_root(&BoundedMultigrid::upper));
  if (multigrid_) multigrid_->start_as_coarser();
  scatter(x);
}

}  // namespace brindle
