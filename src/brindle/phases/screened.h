/// Screened smoothing: numbers of any length on a phase graph, near to what they are drawn to.
#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <vector>

#include "brindle/phase_graph.h"
#include "brindle/progress.h"

namespace brindle {

/// How far to go, and what else there is beside this process.
struct ScreenedOptions {
  int max_iterations = 200;
  float tolerance = 1e-3f;  ///< ends when the residual has fallen to this share of the first one
  bool of_anchors = false;  ///< to this share of what the anchors are, whatever the start

  /// Nodes from this one on belong to other ranks; all of the graph by default.
  std::size_t own = ~std::size_t{0};
  /// Gives these nodes the values that their owners have; called by all ranks alike.
  std::function<void(std::span<Complex>)> exchange = {};
  /// The sum over all ranks.
  std::function<double(double)> total = {};

  /// The sum of |A_ij| over every node's edges, where it is known; empty: it is found.
  std::span<const float> degrees = {};

  Progress progress = {};  ///< hears of every iteration
};

/// From `start` towards the numbers u_i that minimise
///
///     sum over edges w_ij |u_i - A_ij u_j / w_ij|^2 + sum over nodes s_i |u_i - T_i / s_i|^2
///
/// with T_i = `graph.anchor`, w_ij = |A_ij|, reflecting edges as B_ij conj(u_j), and the screening
/// s_i (one per node, 0 or above). Where s_i is 0 nothing is known, and the smoothest goes on; how
/// long u_i is says how much what is known agrees around it. The system is linear in real and
/// imaginary parts: conjugate gradients, with the diagonal as preconditioner (Hestenes and Stiefel
/// 1952). Throws Cancelled if the options' progress asks for it. Every iteration lowers the energy;
/// bits do not depend on threads.
std::vector<Complex> smooth_screened(const PhaseGraph& graph, std::span<const float> screening,
                                     std::vector<Complex> start,
                                     const ScreenedOptions& options = {});

}  // namespace brindle
