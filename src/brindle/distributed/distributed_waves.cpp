#include "brindle/distributed_waves.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "brindle/communicator.h"
#include "brindle/distributed/surface/rank_surface.h"
#include "brindle/distributed_pattern.h"
#include "brindle/error.h"
#include "brindle/waves/direction_graph.h"
#include "brindle/waves/frequency_parts.h"

namespace brindle {
namespace {

void check_waves(const WaveSet& waves, std::size_t vertices) {
  for (const std::size_t count : {waves.directions.size(), waves.frequencies.size()}) {
    if (count == vertices) continue;
    throw Error("a piece of " + std::to_string(vertices) + " vertices has " +
                std::to_string(count) + " waves; give one for each");
  }
}

/// Counts own vertices, all of whose neighbours are known.
WaveTally tally_own(const RankSurface& surface, const WaveSet& of_piece) {
  WaveSet waves;
  waves.directions.resize(surface.graph.own, Vec3::Zero());
  waves.frequencies.resize(surface.graph.own, 1);
  surface.copy_to_own<Vec3>(of_piece.directions, waves.directions);
  surface.copy_to_own<float>(of_piece.frequencies, waves.frequencies);
  return tally_waves({surface.mesh, surface.graph.adjacency, surface.normals}, waves);
}

/// The k-th smallest, from 0, of all ranks' numbers, which must be non-negative and not NaN;
/// infinity if there are fewer. Such doubles are ordered like their bits.
double kth_smallest(Communicator& ranks, std::span<const double> numbers, std::size_t k) {
  std::uint64_t low = 0;
  auto high = std::bit_cast<std::uint64_t>(std::numeric_limits<double>::infinity());
  while (low < high) {
    const std::uint64_t middle = low + (high - low) / 2;
    const auto bound = std::bit_cast<double>(middle);
    const auto counted =
        std::ranges::count_if(numbers, [&](double number) { return number <= bound; });
    if (ranks.sum(static_cast<std::size_t>(counted)) > k) {
      high = middle;
    } else {
      low = middle + 1;
    }
  }
  return std::bit_cast<double>(low);
}

/// The median of all ranks' numbers, of which there are `count`. A single rank sorts in place.
double median(Communicator& ranks, std::vector<double>& numbers, std::size_t count) {
  if (ranks.size() > 1) return kth_smallest(ranks, numbers, count / 2);
  const auto middle = numbers.begin() + static_cast<std::ptrdiff_t>(count / 2);
  std::nth_element(numbers.begin(), middle, numbers.end());
  return *middle;
}

}  // namespace

WaveMetrics measure_waves(const DistributedSurface& surface, const WaveSet& waves) {
  const RankSurface& own = surface.rank_surface();
  Communicator& ranks = *own.ranks;
  WaveTally tally;
  ranks.throw_on_all([&] {
    check_waves(waves, own.vertex_of_piece.size());
    tally = tally_own(own, waves);
  });
  tally.used = ranks.sum(tally.used);
  tally.without_wave = ranks.sum(tally.without_wave);
  tally.frequency_sum = ranks.sum(tally.frequency_sum);
  tally.frequency_max = ranks.greatest(tally.frequency_max);
  tally.frequency_min = -ranks.greatest(-tally.frequency_min);
  WaveMetrics metrics = metrics_of(tally, surface.diagonal());
  std::vector<double>& edges = tally.edges_per_period;
  const std::size_t count = ranks.sum(edges.size());
  if (count == 0) {
    metrics.stripes = 0;
    return metrics;
  }
  double least = std::numeric_limits<double>::infinity();
  for (const double number : edges) least = std::min(least, number);
  metrics.edges_per_period_min = -ranks.greatest(-least);
  metrics.edges_per_period_median = median(ranks, edges, count);
  return metrics;
}

FrequencyField frequencies_by(const DistributedSurface& surface, const DataArray& array,
                              float frequency, const FrequencyRange& range) {
  const RankSurface& own = surface.rank_surface();
  NumberExtent extent;
  own.ranks->throw_on_all([&] { extent = extent_of(array, own.used_own()); });
  for (const NumberExtent& other : own.ranks->all(extent)) {
    extent.lowest = std::min(extent.lowest, other.lowest);
    extent.highest = std::max(extent.highest, other.highest);
  }
  FrequencyField frequencies;
  own.ranks->throw_on_all([&] { frequencies = frequencies_by(array, extent, frequency, range); });
  return frequencies;
}

bool PieceSurface::any(bool here) const { return surface_.rank_surface().ranks->any(here); }

std::size_t PieceSurface::opposite_edges() const {
  const RankSurface& own = surface_.rank_surface();
  return own.ranks->sum(count_opposite_edges(*own.graph.adjacency, own.normals)) / 2;
}

std::size_t PieceSurface::drop_waves(DirectionField& directions,
                                     FrequencyField& frequencies) const {
  Communicator& ranks = *surface_.rank_surface().ranks;
  std::size_t dropped = 0;
  for (std::size_t v = 0; v < frequencies.size(); ++v) {
    dropped += surface_.is_own()[v] != 0 && std::isnan(frequencies[v]) && !directions[v].isZero(0);
  }
  FrequencySum all;
  for (const FrequencySum& of_rank : ranks.all(sum_of(frequencies, surface_.is_own()))) {
    all.sum += of_rank.sum;
    all.count += of_rank.count;
  }
  drop_waves_without_frequency(directions, frequencies, all.mean());
  return ranks.sum(dropped);
}

}  // namespace brindle
