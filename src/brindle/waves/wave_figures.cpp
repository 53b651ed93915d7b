#include "brindle/wave_figures.h"

#include <algorithm>
#include <cmath>

#include "brindle/base/text.h"
#include "brindle/error.h"
#include "brindle/waves/fineness.h"

namespace brindle {
namespace {

constexpr double kFewestEdges = 2;         // a period
constexpr double kMostWithoutWave = 0.01;  // share of the vertices
constexpr int kMostSubdivisions = 6;       // that are worth proposing

std::string rounded_text(double number, int digits) { return formatted("%.*g", digits, number); }

std::string of_all(std::size_t count, std::size_t all) {
  return std::to_string(count) + " of " + std::to_string(all);
}

std::string subdivisions_proposed(double edges_per_period, const WarningWords& words) {
  const int times = static_cast<int>(std::ceil(std::log2(kFewestEdges / edges_per_period)));
  return times > kMostSubdivisions ? "" : or_subdivide(times, words);
}

}  // namespace

bool WaveFigures::are_too_fine() const {
  return edges_per_period_median > 0 && edges_per_period_median < kFewestEdges;
}

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

WaveFigures figures_of(const WaveTally& tally, double diagonal) {
  WaveFigures figures;
  figures.used = tally.used;
  figures.without_wave = tally.without_wave;
  const std::size_t with_wave = tally.used - tally.without_wave;
  if (with_wave == 0) return figures;
  figures.frequency_min = tally.frequency_min;
  figures.frequency_max = tally.frequency_max;
  figures.stripes = tally.frequency_sum / static_cast<double>(with_wave) * diagonal;
  return figures;
}

WaveFigures measure_waves(const Surface& surface, const WaveSet& waves) {
  WaveTally tally = tally_waves(surface, waves);
  std::vector<double>& edges_per_period = tally.edges_per_period;
  WaveFigures figures =
      figures_of(tally, static_cast<double>(bounding_box(surface.mesh).diagonal()));
  if (edges_per_period.empty()) {
    figures.stripes = 0;
    return figures;
  }
  const auto median =
      edges_per_period.begin() + static_cast<std::ptrdiff_t>(edges_per_period.size() / 2);
  std::nth_element(edges_per_period.begin(), median, edges_per_period.end());
  figures.edges_per_period_median = *median;
  figures.edges_per_period_min = *std::min_element(edges_per_period.begin(), median + 1);
  return figures;
}

void check_figures(const WaveFigures& figures, const WarningWords& words, const std::string& why) {
  if (figures.used > 0 && figures.without_wave == figures.used) {
    throw Error(
        "no vertex has a wave: " + words.source + " is zero, not finite or normal to the surface " +
        (why.empty() ? "at all of them" : "at all others" + why) + "; choose other directions");
  }
  const double edges = figures.edges_per_period_median;
  if (edges != 0 && edges <= kFewestEdgesAtHalf) refuse_noise(edges, "", words.fewer);
}

std::string or_subdivide(int times, const WarningWords& words) {
  if (words.subdivide.empty()) return "";
  return "; or " + words.subdivide + " " + std::to_string(words.subdivided + times);
}

std::vector<std::string> wave_warnings(const WaveFigures& figures, const WarningWords& words) {
  std::vector<std::string> result;
  const std::size_t without = figures.without_wave;
  if (static_cast<double>(without) > kMostWithoutWave * static_cast<double>(figures.used)) {
    result.push_back(of_all(without, figures.used) + " vertices have no wave: " + words.source +
                     " is zero, not finite or normal to the surface there");
  }
  if (figures.are_too_fine()) {
    const double edges = figures.edges_per_period_median;
    result.push_back("at half of the vertices a wave passes " + rounded_text(edges, 3) +
                     " edges a period or fewer; below two, stripes may come out as noise; " +
                     words.fewer + subdivisions_proposed(edges, words));
  }
  return result;
}

}  // namespace brindle
