/// Plain solvers on phase graphs, in double precision and node after node: the tests' oracle.
#pragma once

#include <complex>
#include <map>
#include <span>
#include <utility>
#include <vector>

#include "brindle/phases/coloring.h"
#include "brindle/solver.h"

namespace brindle::testing_support {

using Number = std::complex<double>;
using Phases = std::vector<Number>;

/// t_i of Eq. 8, with the anchor.
inline Number target_of(const PhaseGraph& graph, const Phases& z, Index i) {
  Number t = graph.anchor.empty() ? Number(0) : Number(graph.anchor[i]);
  for (Index edge = graph.adjacency->offsets[i]; edge < graph.adjacency->offsets[i + 1]; ++edge) {
    const Number z_j = z[graph.adjacency->neighbors[edge]];
    t += Number(graph.coupling[edge]) * (graph.reflecting[edge] ? std::conj(z_j) : z_j);
  }
  return t;
}

/// Eq. 4 and 5 over the sum of all weights; anchors do not count.
inline double energy_of(const PhaseGraph& graph, const Phases& z) {
  double sum = 0, weights = 0;
  for (Index i = 0; i < graph.node_count(); ++i) {
    for (Index edge = graph.adjacency->offsets[i]; edge < graph.adjacency->offsets[i + 1]; ++edge) {
      const Number z_j = z[graph.adjacency->neighbors[edge]], c = graph.coupling[edge];
      const Number predicted = c * (graph.reflecting[edge] ? std::conj(z_j) : z_j);
      sum += (std::abs(c) - (std::conj(z[i]) * predicted).real()) / 2;
      weights += std::abs(c);
    }
  }
  return weights > 0 ? sum / weights : 0;
}

/// z_i = t_i / |t_i|, colour by colour (Eq. 10 without momentum); over-relaxed as `sweep` is.
inline void sweep_plainly(const PhaseGraph& graph, const Coloring& coloring, Phases& z,
                          double over_relaxation = 1) {
  for (Index color = 0; color < coloring.color_count; ++color) {
    for (Index i = 0; i < graph.node_count(); ++i) {
      const Number t = coloring.color[i] == color ? target_of(graph, z, i) : Number(0);
      if (t == Number(0)) continue;
      const Number beyond = z[i] + over_relaxation * (t / std::abs(t) - z[i]);
      z[i] = beyond / std::abs(beyond);
    }
  }
}

/// The paper's relaxation: Eq. 8 to 12 from `z`. Returns the energy before and after each
/// iteration.
inline std::vector<double> relax_plainly(const PhaseGraph& graph, const Coloring& coloring,
                                         const SolverOptions& options, Phases& z) {
  Phases momentum(z.size());
  std::vector<double> energies = {energy_of(graph, z)};
  for (int iteration = 0; iteration < options.max_iterations; ++iteration) {
    const bool skips = options.skip_last_third && iteration % 2 == 1;
    const Index colors = coloring.color_count - (skips ? coloring.color_count / 3 : 0);
    for (Index color = 0; color < colors; ++color) {
      for (Index i = 0; i < graph.node_count(); ++i) {
        if (coloring.color[i] != color) continue;
        const Number t = target_of(graph, z, i), pulled = t + momentum[i];            // Eq. 8
        momentum[i] = static_cast<double>(options.momentum) * (t - z[i]);             // Eq. 9, 11
        if (t != Number(0) && pulled != Number(0)) z[i] = pulled / std::abs(pulled);  // Eq. 10
      }
    }
    const double before = energies.back(), drop = before - energy_of(graph, z);
    energies.push_back(before - drop);
    if (!(drop > 0) || drop / before < static_cast<double>(options.epsilon)) break;  // Eq. 12
  }
  return energies;
}

/// Coarse couplings A_IJ and B_IJ: exact sums of those of a graph (docs/method.md, "Multilevel
/// solver"), with z_i = g_i Z_I or, where i is `conjugated`, g_i conj(Z_I).
inline std::map<std::pair<Index, Index>, std::pair<Number, Number>> sums_plainly(
    const PhaseGraph& graph, const std::vector<Index>& parent, const Phases& gauge,
    const std::vector<bool>& conjugated) {
  std::map<std::pair<Index, Index>, std::pair<Number, Number>> sums;
  for (Index i = 0; i < graph.node_count(); ++i) {
    for (Index edge = graph.adjacency->offsets[i]; edge < graph.adjacency->offsets[i + 1]; ++edge) {
      const Index j = graph.adjacency->neighbors[edge];
      if (parent[i] == parent[j]) continue;
      const bool reflects = graph.reflecting[edge] != 0;
      Number c = std::conj(gauge[i]) * Number(graph.coupling[edge]) *
                 (reflects ? std::conj(gauge[j]) : gauge[j]);
      if (conjugated[i]) c = std::conj(c);
      auto& [a, b] = sums[{parent[i], parent[j]}];
      (reflects != (conjugated[i] != conjugated[j]) ? b : a) += c;
    }
  }
  return sums;
}

}  // namespace brindle::testing_support
