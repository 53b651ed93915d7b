#include <algorithm>
#include <limits>
#include <string>
#include <vector>

#include "brindle/distributed/surface/rank_surface.h"
#include "brindle/distributed/surface/selection.h"
#include "brindle/distributed_pattern.h"
#include "brindle/error.h"

namespace brindle {
namespace {

void check_waves(const WaveSet& waves, std::size_t vertices) {
  for (const std::size_t count : {waves.directions.size(), waves.frequencies.size()}) {
    if (count == vertices) continue;
    throw Error("a piece of " + std::to_string(vertices) + " vertices has " +
                std::to_string(count) + " waves; give one for each");
  }
}

/// The waves of the rank's own vertices, whose neighbours it knows all.
WaveTally tally_own(const RankSurface& surface, const WaveSet& of_piece) {
  WaveSet waves;
  waves.directions.resize(surface.graph.own, Vec3::Zero());
  waves.frequencies.resize(surface.graph.own, 1);
  for (std::size_t p = 0; p < of_piece.directions.size(); ++p) {
    const Index v = surface.vertex_of_piece[p];
    if (v >= surface.graph.own) continue;
    waves.directions[v] = of_piece.directions[p];
    waves.frequencies[v] = of_piece.frequencies[p];
  }
  return tally_waves({surface.mesh, surface.graph.adjacency, surface.normals}, waves);
}

/// The middle one of all ranks' numbers, of which there are `count`. One rank has no messages to
/// save, and sorts in place.
double median(Communicator& ranks, std::vector<double>& numbers, std::size_t count) {
  if (ranks.size() > 1) return kth_smallest(ranks, numbers, count / 2);
  const auto middle = numbers.begin() + static_cast<std::ptrdiff_t>(count / 2);
  std::nth_element(numbers.begin(), middle, numbers.end());
  return *middle;
}

}  // namespace

WaveFigures measure_waves(const DistributedSurface& surface, const WaveSet& waves) {
  const RankSurface& own = surface.rank_surface();
  Communicator& ranks = *own.ranks;
  WaveTally tally;
  ranks.together([&] {
    check_waves(waves, own.vertex_of_piece.size());
    tally = tally_own(own, waves);
  });
  tally.used = ranks.sum(tally.used);
  tally.without_wave = ranks.sum(tally.without_wave);
  tally.frequency_sum = ranks.sum(tally.frequency_sum);
  tally.frequency_max = ranks.greatest(tally.frequency_max);
  tally.frequency_min = -ranks.greatest(-tally.frequency_min);
  WaveFigures figures = figures_of(tally, surface.diagonal());
  std::vector<double>& edges = tally.edges_per_period;
  const std::size_t count = ranks.sum(edges.size());
  if (count == 0) {
    figures.stripes = 0;
    return figures;
  }
  double least = std::numeric_limits<double>::infinity();
  for (const double number : edges) least = std::min(least, number);
  figures.edges_per_period_min = -ranks.greatest(-least);
  figures.edges_per_period_median = median(ranks, edges, count);
  return figures;
}

}  // namespace brindle
