/// The phase graph: the input of all solvers (docs/method.md, "Phase graph").
#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include "brindle/export.h"
#include "brindle/phase_shift.h"
#include "brindle/progress.h"
#include "brindle/types.h"

namespace BRINDLE_EXPORT brindle {

/// Unknown phases z_i = exp(i Phi_i) on nodes and one coupling per directed edge j -> i. The target
/// of node i is
///
///     t_i = sum_j A_ij z_j + B_ij conj(z_j) + T_i                                (paper, Eq. 8)
///
/// where the coupling of a direct edge is A_ij = w exp(i Phi_ji) and that of a reflecting edge
/// B_ij = -w exp(-i Phi_ji) (Eq. 7). Couplings are symmetric: A_ji = conj(A_ij), B_ji = B_ij.
struct PhaseGraph {
  std::shared_ptr<const Adjacency> adjacency;
  std::vector<Complex> coupling;         ///< one per directed edge, in the row of i
  std::vector<std::uint8_t> reflecting;  ///< one per directed edge: 1 if `coupling` is a B_ij
  std::vector<Complex> anchor;           ///< T_i, one per node; empty for none

  std::size_t node_count() const { return adjacency->node_count(); }
};

/// A coarser graph of averaged waves (paper, 3.4).
struct AveragedLevel {
  PhaseGraph graph;
  std::vector<Index> parent;      ///< node of the finer graph -> node of `graph`
  std::vector<Complex> transfer;  ///< z_i = transfer_i z_parent, or transfer_i conj(z_parent)...
  std::vector<std::uint8_t> transfer_reflects;  ///< ...where this is 1
};

/// One wave per node. Waves are valid if every position is finite, every direction a unit vector
/// (to half a percent) or zero, and every frequency finite and above zero, also where there is no
/// wave.
struct WaveSet {
  std::vector<Vec3> positions;
  std::vector<Vec3> directions;    ///< unit tangent vectors or zero (no wave, couplings are 0)
  std::vector<float> frequencies;  ///< stripes per unit length

  Wave wave(std::size_t node) const {
    return {positions[node], directions[node], frequencies[node]};
  }
};

/// Couples waves along all edges of `adjacency`, with the paper's weight w = |<d_i, d_j>|, times
/// `edge_weights` (one per directed edge, symmetric, not negative) if given. Throws Error if sizes
/// do not match and for waves that are not valid; Cancelled if `progress` cancels.
PhaseGraph build_phase_graph(std::shared_ptr<const Adjacency> adjacency, const WaveSet& waves,
                             PhaseShiftKind kind = PhaseShiftKind::aligned,
                             std::span<const float> edge_weights = {},
                             const Progress& progress = {});

/// Sets anchors T_i = lambda deg_i z_i with deg_i = sum_j |A_ij| + |B_ij|, so that `lambda` (0 to
/// 1e6) is relative to a node's couplings. `z` has one unit number per node, or 0 for no anchor.
/// Throws Error for other phases and lambdas.
void anchor_phases(PhaseGraph& graph, std::span<const Complex> z, float lambda);

/// The energy of Eq. 4 and 5 over the sum of all weights: between 0 and 1, about 0.5 for random
/// phases, 0 if all weights are 0. Anchors do not count. NaN if a coupling or a phase is NaN. `z`
/// has one unit number per node.
double energy(const PhaseGraph& graph, std::span<const Complex> z);

}  // namespace brindle
