#include "brindle/phase_graph.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "brindle/base/elementary.h"
#include "brindle/base/parallel.h"
#include "brindle/error.h"
#include "brindle/waves/energy_sums.h"
#include "brindle/waves/wave_check.h"

namespace brindle {
namespace {

struct Coupling {
  Complex value;
  bool reflecting;
};

/// Eq. 1, 2, 7.
Coupling coupled(PhaseShiftKind kind, const Wave& j, const Wave& i, float edge_weight) {
  const float weight = std::abs(i.direction.dot(j.direction)) * edge_weight;
  const PhaseShift shift = phase_shift(kind, j, i);
  return {shift.reflecting ? -elementary::polar(weight, -shift.radians)
                           : elementary::polar(weight, shift.radians),
          shift.reflecting};
}

}  // namespace

PhaseGraph build_phase_graph(std::shared_ptr<const Adjacency> adjacency, const WaveSet& waves,
                             PhaseShiftKind kind, std::span<const float> edge_weights,
                             const Progress& progress) {
  const std::size_t nodes = adjacency->node_count();
  const std::size_t edges = adjacency->directed_edge_count();
  check_coupled_waves(*adjacency, waves, edge_weights);
  PhaseGraph graph;
  graph.coupling.resize(edges);
  graph.reflecting.resize(edges);
  parallel_for(nodes, progress, [&](std::size_t begin, std::size_t end) {
    for (Index i = static_cast<Index>(begin); i < end; ++i) {
      const Wave w_i = waves.wave(i);
      for (Index edge = adjacency->offsets[i]; edge < adjacency->offsets[i + 1]; ++edge) {
        const Index j = adjacency->neighbors[edge];
        const Wave w_j = waves.wave(j);
        const float weight = edge_weights.empty() ? 1 : edge_weights[edge];
        const Coupling found = coupled(kind, w_j, w_i, weight);
        graph.coupling[edge] = found.value;
        graph.reflecting[edge] = found.reflecting;
      }
    }
  });
  graph.adjacency = std::move(adjacency);
  return graph;
}

void anchor_phases(PhaseGraph& graph, std::span<const Complex> z, float lambda) {
  if (!is_weight(lambda)) throw Error("lambda must be from 0 to 1e6");
  const std::size_t nodes = graph.node_count();
  check_last_phases(z, nodes);
  const Adjacency& adjacency = *graph.adjacency;
  graph.anchor.resize(nodes);
  parallel_for(nodes, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      float degree = 0;
      for (Index edge = adjacency.offsets[i]; edge < adjacency.offsets[i + 1]; ++edge) {
        degree += std::abs(graph.coupling[edge]);
      }
      graph.anchor[i] = lambda * degree * z[i];
    }
  });
}

double energy(const PhaseGraph& graph, std::span<const Complex> z) {
  const Adjacency& adjacency = *graph.adjacency;
  const auto sums_of = [&](std::size_t begin, std::size_t end) {
    EnergySums sum;
    for (std::size_t i = begin; i < end; ++i) {
      const std::complex<double> z_i = z[i];
      for (Index edge = adjacency.offsets[i]; edge < adjacency.offsets[i + 1]; ++edge) {
        const std::complex<double> z_j = z[adjacency.neighbors[edge]];
        const std::complex<double> c = graph.coupling[edge];
        const std::complex<double> target = c * (graph.reflecting[edge] ? std::conj(z_j) : z_j);
        const double weight = std::sqrt(std::norm(c));
        sum.weight += weight;
        sum.energy += 0.5 * (weight - (std::conj(z_i) * target).real());
      }
    }
    return sum;
  };
  return parallel_sum<EnergySums>(graph.node_count(), sums_of).relative();
}

}  // namespace brindle
