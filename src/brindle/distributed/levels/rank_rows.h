/// A distributed matrix: each rank has the rows of its own nodes (docs/distributed.md).
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "brindle/communicator.h"
#include "brindle/distributed/halo.h"
#include "brindle/distributed/levels/rank_graph.h"
#include "brindle/distributed/parts_on_first.h"
#include "brindle/distributed/surface/rank_surface.h"
#include "brindle/types.h"
#include "brindle/waves/bounded_multigrid.h"
#include "brindle/waves/relaxed_frequency_solver.h"
#include "brindle/waves/row_levels.h"

namespace brindle {

// Coarse rows that rank 0 holds alone.

/// All functions are collective, with values of own nodes.
class GatheredRows {
 public:
  /// From the coarsest distributed graph, whose rows are those of `level`.
  GatheredRows(Communicator& ranks, const StrengthGraph& graph, const NodeHalo& halo,
               const RowLevel& level);

  void set(const RowMatrix& matrix);

  /// As the functions of the same names in MultigridPeers, for own nodes.
  void solve(std::span<const float> right, int visits, std::span<float> x);
  void start(const RowProblem& problem, std::span<float> x);

 private:
  void gather_graph(Communicator& ranks, const StrengthGraph& graph, const NodeHalo& halo,
                    const RowLevel& level);
  void find_entries(const Adjacency& adjacency);
  std::span<float> on_root(std::span<float> (BoundedMultigrid::*part)());
  void take_nodes(std::span<const float> own, std::span<float> by_place);
  void scatter(std::span<float> own);

  PartsOnFirst nodes_, entries_;
  // On rank 0 only.
  std::shared_ptr<const RowLevels> levels_;
  std::unique_ptr<BoundedMultigrid> multigrid_;
  std::vector<Index> entry_of_;  ///< maps the ranks' entries to entries here
  std::vector<float> all_;       ///< received from, or to be sent to, all ranks
};

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

// The distributed spacing tolerance.

/// Collective. The owners' values at all vertices of a rank, from values by vertex of each
/// partition. Empty if no rank has any.
std::vector<float> owners_values(const RankSurface& surface, std::span<const float> of_piece);

/// Collective. The setting of a rank's own vertices and ghosts; `slack` is by vertex of the
/// partition.
std::shared_ptr<const RelaxedFrequencySetting> rank_relaxed_setting(const RankSurface& surface,
                                                                    const Slack& slack);

/// Collective. Throws Error on all ranks for a tolerance that `check` rejects, or that is per
/// vertex on some ranks only.
void check_on_all(const RankSurface& surface, const Slack& slack);

}  // namespace brindle
