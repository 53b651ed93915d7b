#include "brindle/wave_metrics.h"

#include <algorithm>

#include "brindle/error.h"
#include "brindle/waves/wave_check.h"

namespace brindle {
namespace {

constexpr double kMostWithoutWave = 0.01;  // share of the vertices

std::string of_all(std::size_t count, std::size_t all) {
  return std::to_string(count) + " of " + std::to_string(all);
}

}  // namespace

WaveTally tally_waves(const Surface& surface, const WaveSet& waves) {
  WaveTally tally;
  tally.edges_per_period.reserve(waves.directions.size());
  for (Index v = 0; v < waves.directions.size(); ++v) {
    const std::span<const Index> neighbors = surface.neighborhood->of(v);
    if (neighbors.empty()) continue;
    ++tally.used;
    if (waves.directions[v].isZero(0)) {
      ++tally.without_wave;
      continue;
    }
    const double frequency = waves.frequencies[v];
    tally.frequency_sum += frequency;
    tally.frequency_min = std::min(tally.frequency_min, frequency);
    tally.frequency_max = std::max(tally.frequency_max, frequency);
    const double length =
        mean_length_along(surface.mesh.positions, v, neighbors, waves.directions[v]);
    if (length > 0) tally.edges_per_period.push_back(1 / (frequency * length));
  }
  return tally;
}

WaveMetrics metrics_of(const WaveTally& tally, double diagonal) {
  WaveMetrics metrics;
  metrics.used = tally.used;
  metrics.without_wave = tally.without_wave;
  const std::size_t with_wave = tally.used - tally.without_wave;
  if (with_wave == 0) return metrics;
  metrics.frequency_min = tally.frequency_min;
  metrics.frequency_max = tally.frequency_max;
  metrics.stripes = tally.frequency_sum / static_cast<double>(with_wave) * diagonal;
  return metrics;
}

WaveMetrics measure_waves(const Surface& surface, const WaveSet& waves) {
  WaveTally tally = tally_waves(surface, waves);
  std::vector<double>& edges_per_period = tally.edges_per_period;
  WaveMetrics metrics =
      metrics_of(tally, static_cast<double>(bounding_box(surface.mesh).diagonal()));
  if (edges_per_period.empty()) {
    metrics.stripes = 0;
    return metrics;
  }
  const auto median =
      edges_per_period.begin() + static_cast<std::ptrdiff_t>(edges_per_period.size() / 2);
  std::nth_element(edges_per_period.begin(), median, edges_per_period.end());
  metrics.edges_per_period_median = *median;
  metrics.edges_per_period_min = *std::min_element(edges_per_period.begin(), median + 1);
  return metrics;
}

void check_metrics(const WaveMetrics& metrics, const WarningWords& words, const std::string& why) {
  if (metrics.used > 0 && metrics.without_wave == metrics.used) {
    const std::string normal =
        words.source + " is zero, not finite or normal to the surface at all ";
    throw Error("no vertex has a wave" +
                (why.empty() ? ": " + normal + "of them" : why + "; " + normal + "others") +
                "; choose other directions");
  }
  const double edges = metrics.edges_per_period_median;
  if (edges != 0 && edges <= kFewestEdgesAtHalf) refuse_noise(edges, "", words.fewer);
}

std::vector<std::string> wave_warnings(const WaveMetrics& metrics, const WarningWords& words) {
  std::vector<std::string> result;
  const std::size_t without = metrics.without_wave;
  if (static_cast<double>(without) > kMostWithoutWave * static_cast<double>(metrics.used)) {
    result.push_back(of_all(without, metrics.used) + " vertices have no wave: " + words.source +
                     " is zero, not finite or normal to the surface there");
  }
  return result;
}

}  // namespace brindle
