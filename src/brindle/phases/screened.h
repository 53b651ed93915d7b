/// Screened smoothing: complex numbers of any length on a phase graph, close to known values.
#pragma once

#include <span>
#include <vector>

#include "brindle/phase_graph.h"
#include "brindle/progress.h"

namespace brindle {

/// When the iteration stops.
struct ScreenedOptions {
  int max_iterations = 200;
  float tolerance = 1e-3f;  ///< stop when the residual is below this share of the first residual...
  bool of_anchors = false;  ///< ...or, if true, of the anchors, for any start

  /// The sum of |A_ij| over each node's edges, if known; empty: computed.
  std::span<const float> degrees = {};

  Progress progress = {};  ///< one report per iteration
};

/// Iterates from `start` towards the numbers u_i that minimise
///
///     sum over edges w_ij |u_i - A_ij u_j / w_ij|^2 + sum over nodes s_i |u_i - T_i / s_i|^2
///
/// with T_i = `graph.anchor`, w_ij = |A_ij|, B_ij conj(u_j) on reflecting edges, and the screening
/// s_i (one per node, 0 or above). Nodes with s_i = 0 have no data and get the smoothest
/// continuation. |u_i| measures the agreement of nearby data. The system is linear in real and
/// imaginary parts. Conjugate gradients with the diagonal as preconditioner (Hestenes and Stiefel
/// 1952) solve it; every iteration lowers the energy. Throws Cancelled if `options.progress`
/// cancels. Results have the same bits for any number of threads.
std::vector<Complex> smooth_screened(const PhaseGraph& graph, std::span<const float> screening,
                                     std::vector<Complex> start,
                                     const ScreenedOptions& options = {});

}  // namespace brindle
