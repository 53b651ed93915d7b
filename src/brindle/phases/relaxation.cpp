#include "brindle/phases/relaxation.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "brindle/base/random.h"
#include "brindle/base/stopwatch.h"
#include "brindle/error.h"
#include "brindle/phases/coloring.h"

namespace brindle {
namespace {

double sum_of_weights(const PhaseGraph& graph) {
  double sum = 0;
  for (const Complex& coupling : graph.coupling) sum += std::sqrt(std::norm(coupling));
  return sum;
}

/// One iteration over the first colours; returns the decrease of the energy.
double relax_colors(const SlicedLayout& layout, const SlicedCouplings& couplings,
                    std::span<Complex> z, Momentum& momentum, Index colors,
                    const Progress& progress) {
  double drop = 0;
  for (Index color = 0; color < colors; ++color) {
    progress.tick();
    drop += relax_color(layout, couplings, z, momentum, color);
  }
  return drop;
}

}  // namespace

SlicedLayout relaxation_layout(const Adjacency& adjacency, std::uint32_t seed,
                               const Progress& progress) {
  const Coloring coloring = luby_coloring(adjacency, seed, progress);
  const std::vector<Index> order = breadth_first_order(adjacency, progress);
  return sliced_layout(adjacency, coloring, order, {}, progress);
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
  JobStages stages(progress, {{"colors", 1}, {"relaxation", 9}});
  const SlicedLayout layout =
      relaxation_layout(*graph.adjacency, options.seed, stages.begin("colors"));
  solution.topology_milliseconds = watch.lap();

  const Progress relaxing = stages.begin("relaxation");
  SlicedCouplings couplings(layout);
  load_couplings(graph, layout, couplings);
  relaxing.tick();
  std::vector<Complex> z = start_phases(layout, start, options.seed);
  Momentum momentum{options.momentum, std::vector<Complex>(layout.slot_count())};
  const double weight = sum_of_weights(graph);
  const Index all = layout.color_count();
  const Index first_two_thirds = all - all / 3;

  relaxing.tick();
  solution.energy_per_iteration.push_back(energy(graph, to_nodes(layout, z)));
  while (weight > 0 && solution.iterations < options.max_iterations) {
    const double before = solution.energy_per_iteration.back();
    relaxing.report(1 - std::min(1.0, before / 0.5));  // from the energy of random phases to 0
    const bool skip = options.skip_last_third && solution.iterations % 2 == 1;
    const Index colors = skip ? first_two_thirds : all;
    const double drop = relax_colors(layout, couplings, z, momentum, colors, relaxing) / weight;
    solution.energy_per_iteration.push_back(before - drop);
    ++solution.iterations;
    if (!(drop > 0) || drop / before < options.epsilon) break;  // Eq. 12
  }
  solution.z = to_nodes(layout, z);
  solution.solve_milliseconds = watch.lap();
  solution.energy = energy(graph, solution.z);
  return solution;
}

namespace {

/// Returns the phases of a level from those of the next coarser level (3.4).
std::vector<Complex> passed_down(const AveragedLevel& level, const std::vector<Complex>& coarse) {
  std::vector<Complex> z(level.parent.size());
  for (std::size_t i = 0; i < z.size(); ++i) {
    const Complex z_parent = coarse[level.parent[i]];
    z[i] = level.transfer[i] * (level.transfer_reflects[i] ? std::conj(z_parent) : z_parent);
  }
  return z;
}

}  // namespace

PhaseSolution solve_averaged(const PhaseGraph& graph, std::span<const AveragedLevel> levels,
                             const SolverOptions& options, const Progress& progress) {
  if (levels.empty()) {
    throw Error(
        "the averaged solver needs averaged levels of its phase graph; averaged_levels "
        "(waves/averaged_levels.h) makes them");
  }
  // A level takes about as long as all coarser levels together.
  const auto part = [&](std::size_t finer) {
    const double end = std::pow(0.5, static_cast<double>(finer));
    return progress.part(finer == levels.size() ? 0 : end / 2, end);
  };
  PhaseSolution solution = relax(levels.back().graph, options, {}, part(levels.size()));
  for (std::size_t l = levels.size(); l-- > 0;) {
    const PhaseGraph& finer = l > 0 ? levels[l - 1].graph : graph;
    const PhaseSolution coarse = std::move(solution);
    solution = relax(finer, options, passed_down(levels[l], coarse.z), part(l));
    solution.topology_milliseconds += coarse.topology_milliseconds;
    solution.solve_milliseconds += coarse.solve_milliseconds;
  }
  return solution;
}

}  // namespace brindle
