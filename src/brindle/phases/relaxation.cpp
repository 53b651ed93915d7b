#include "brindle/phases/relaxation.h"

#include <cmath>

#include "brindle/base/stopwatch.h"
#include "brindle/phases/coloring.h"
#include "brindle/phases/node_order.h"
#include "brindle/phases/one_at_a_time.h"
#include "brindle/phases/sliced_graph.h"

namespace brindle {
namespace {

double sum_of_weights(const PhaseGraph& graph) {
  double sum = 0;
  for (const Complex& coupling : graph.coupling) sum += std::sqrt(std::norm(coupling));
  return sum;
}

/// One iteration over the colours; returns by how much it lowers the energy. Reports that so much
/// is done.
double relax_colors(const SlicedLayout& layout, const SlicedCouplings& couplings,
                    std::span<Complex> z, Momentum& momentum, Index colors,
                    const Progress& progress, double done) {
  double drop = 0;
  for (Index color = 0; color < colors; ++color) {
    progress.report(done);
    drop += relax_color(layout, couplings, z, momentum, color);
  }
  return drop;
}

}  // namespace

SlicedLayout relaxation_layout(const Adjacency& adjacency, std::uint32_t seed,
                               const Progress& progress) {
  const Coloring coloring = luby_coloring(adjacency, seed, progress.part(0, 0.6));
  const std::vector<Index> order = breadth_first_order(adjacency, progress.part(0.6, 0.8));
  return sliced_layout(adjacency, coloring, order, {}, progress.part(0.8, 1));
}

std::vector<Complex> start_phases(const SlicedLayout& layout, std::span<const Complex> start,
                                  std::uint32_t seed) {
  std::vector<Complex> z(layout.slot_count(), Complex(1));
  to_slots(layout, start, z);
  if (!start.empty()) return z;
  for (Index node = 0; node < layout.slot_of.size(); ++node) {
    z[layout.slot_of[node]] = random_phase(node, seed);
  }
  return z;
}

PhaseSolution relax(const PhaseGraph& graph, const SolverOptions& options,
                    std::span<const Complex> start, const Progress& progress) {
  PhaseSolution solution;
  Stopwatch watch;
  const SlicedLayout layout =
      relaxation_layout(*graph.adjacency, options.seed, progress.step("colors").part(0, 0.1));
  solution.topology_milliseconds = watch.lap();

  const Progress relaxing = progress.step("relaxation").part(0.1, 1);
  relaxing.report(0);
  SlicedCouplings couplings(layout);
  load_couplings(graph, layout, couplings);
  relaxing.report(0);
  std::vector<Complex> z = start_phases(layout, start, options.seed);
  Momentum momentum{options.momentum, std::vector<Complex>(layout.slot_count())};
  const double weight = sum_of_weights(graph);
  const Index all = layout.color_count();
  const Index first_two_thirds = all - all / 3;

  relaxing.report(0);
  solution.energy_per_iteration.push_back(energy(graph, to_nodes(layout, z)));
  while (weight > 0 && solution.iterations < options.max_iterations) {
    const double before = solution.energy_per_iteration.back();
    const double done = 1 - std::min(1.0, before / 0.5);
    const bool skip = options.skip_last_third && solution.iterations % 2 == 1;
    const double drop = relax_colors(layout, couplings, z, momentum, skip ? first_two_thirds : all,
                                     relaxing, done) /
                        weight;
    solution.energy_per_iteration.push_back(before - drop);
    ++solution.iterations;
    if (!(drop > 0) || drop / before < options.epsilon) break;
  }
  solution.z = to_nodes(layout, z);
  solution.solve_milliseconds = watch.lap();
  solution.energy = energy(graph, solution.z);
  return solution;
}

}  // namespace brindle
