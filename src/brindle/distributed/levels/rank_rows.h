/// A distributed matrix: each rank has the rows of its own nodes (docs/distributed.md).
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "brindle/communicator.h"
#include "brindle/distributed/levels/gathered_rows.h"
#include "brindle/distributed/levels/rank_graph.h"
#include "brindle/waves/multigrid_peers.h"

namespace brindle {

/// Levels are merged within ranks until one has fewer than `gather_below` nodes, or hardly fewer
/// than the finer one: rank 0 solves this coarsest level. Nodes of other ranks are ghosts.
class RankRows : public MultigridPeers {
 public:
  /// Both must outlive this object.
  RankRows(Communicator& ranks, const RankGraph& graph, std::size_t gather_below);

  RowLevels make_levels(const Adjacency& adjacency, std::span<const float> strengths) override;
  bool has_first_node() const override { return has_first_node_; }
  std::span<const Index> border_blocks(std::size_t level) const override;
  std::span<const Index> inner_blocks(std::size_t level) const override;
  void start(std::size_t level, std::span<float> by_place) override;
  void finish() override { ranks_.finish(); }
  void sum(std::span<double> values) override;
  double least(double value) override;
  void set_coarsest(const RowMatrix& matrix) override;
  void solve_coarsest(std::span<const float> right, int visits, std::span<float> x) override;
  void start_coarsest(const RowProblem& problem, std::span<float> x) override;

  /// Bytes of halos received so far: 4 per ghost and exchange.
  std::uint64_t halo_bytes() const { return halo_bytes_; }

 private:
  struct Neighbor {
    int rank;
    std::vector<Index> sent;  ///< places
    std::vector<float> out;   ///< parallel to `sent`
    Index first, count;       ///< places of the other rank's nodes
  };
  struct Part {
    std::vector<Neighbor> neighbors;
    std::vector<Index> border, inner;  ///< blocks
  };
  Part make_part(const NodeHalo& halo, std::span<const Index> place_of, Index block_count) const;
  void take_others(std::span<float> coarsest);

  Communicator& ranks_;
  const RankGraph& graph_;
  std::size_t gather_below_;
  bool has_first_node_ = false;
  std::vector<Part> parts_;  ///< by level
  std::optional<GatheredRows> gathered_;
  std::vector<Outgoing> outgoing_;
  std::vector<Incoming> incoming_;
  std::uint64_t halo_bytes_ = 0;
};

}  // namespace brindle
