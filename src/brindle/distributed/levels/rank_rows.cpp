#include "brindle/distributed/levels/rank_rows.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <numeric>
#include <utility>

#include "brindle/error.h"
#include "brindle/waves/wave_check.h"

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

namespace {

/// A triangle belongs to the first rank that owns one of its vertices. A single rank owns all.
FrequencyTriangles frequency_triangles(const RankSurface& surface) {
  FrequencyTriangles triangles{triangles_around_own(surface).triangles, {}, {}};
  if (surface.ranks->size() == 1) return triangles;
  const std::vector<int> owner = owners(*surface.ranks, surface.graph);
  for (const auto& [a, b, c] : triangles.corners) {
    const int first = std::min({owner[a], owner[b], owner[c]});
    triangles.counted.push_back(first == surface.ranks->rank() ? 1 : 0);
  }
  return triangles;
}

}  // namespace

std::vector<float> owners_values(const RankSurface& surface, std::span<const float> of_piece) {
  if (!surface.ranks->any(!of_piece.empty())) return {};
  std::vector<float> values(surface.vertex_count());
  for (std::size_t p = 0; p < of_piece.size(); ++p) {
    values[surface.vertex_of_piece[p]] = of_piece[p];
  }
  surface.exchange_all(std::span(values));
  return values;
}

std::shared_ptr<const RelaxedFrequencySetting> rank_relaxed_setting(const RankSurface& surface,
                                                                    const Slack& slack) {
  Slack of_vertices = slack;
  of_vertices.by_vertex = owners_values(surface, slack.by_vertex);
  of_vertices.branch_penalty = owners_values(surface, slack.branch_penalty);
  auto setting = std::make_shared<RelaxedFrequencySetting>();
  setting->slack = slack_by_vertex(of_vertices, surface.vertex_count());
  setting->slack.resize(surface.graph.node_count());
  exchange(*surface.ranks, surface.graph.halo, std::span(setting->slack));
  setting->branch_penalty = of_vertices.branch_penalty;
  setting->triangles = frequency_triangles(surface);
  setting->triangles.weights =
      penalty_weights(setting->triangles.corners, of_vertices.branch_penalty);
  setting->adjacency = surface.graph.adjacency;
  return setting;
}

void check_on_all(const RankSurface& surface, const Slack& slack) {
  const std::size_t vertices = surface.vertex_of_piece.size();
  surface.ranks->throw_on_all([&] { check_slack(slack, vertices); });
  for (const auto* list : {&slack.by_vertex, &slack.branch_penalty}) {
    const bool is_given = surface.ranks->any(!list->empty());
    surface.ranks->throw_on_all([&] {
      if (!is_given || !list->empty() || vertices == 0) return;
      throw Error(
          "slack: other ranks have a number for each vertex, and this one has none; give one to "
          "each vertex of all pieces");
    });
  }
}

}  // namespace brindle
