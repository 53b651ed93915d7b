#include "wave_figures.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <vector>

#include "brindle/error.h"
#include "formatted.h"

namespace brindle::tool {
namespace {

constexpr double kFewestEdges = 2;  // a period
constexpr double kFewestEdgesAtAll = 1e-4;
constexpr double kMostWithoutWave = 0.01;  // share of the vertices
constexpr double kMostBranches = 0.1;      // share of the triangles
constexpr int kMostSubdivisions = 3;       // that are worth proposing

const char* const kRemedies =
    "take fewer --stripes, or a lower --frequency, which counts stripes per unit of the mesh's own "
    "length";

double mean_length_along(const Surface& surface, Index vertex, const Vec3& direction) {
  const std::span<const Index> neighbors = surface.neighborhood->of(vertex);
  double sum = 0;
  for (const Index neighbor : neighbors) {
    const Vec3 edge = surface.mesh.positions[neighbor] - surface.mesh.positions[vertex];
    sum += std::abs(static_cast<double>(edge.dot(direction)));
  }
  return sum / static_cast<double>(neighbors.size());
}

bool is_too_fine(const WaveFigures& figures) {
  const double edges = figures.edges_per_period_median;
  return edges > 0 && edges < kFewestEdges;  // 0: no edge runs along any wave
}

std::string subdivisions_proposed(double edges_per_period) {
  const int times = static_cast<int>(std::ceil(std::log2(kFewestEdges / edges_per_period)));
  return times <= kMostSubdivisions ? formatted("; or --subdivide %d", times) : "";
}

}  // namespace

WaveTally tally_waves(const Surface& surface, const WaveSet& waves) {
  WaveTally tally;
  tally.edges_per_period.reserve(waves.directions.size());
  for (Index v = 0; v < waves.directions.size(); ++v) {
    if (surface.neighborhood->of(v).empty()) continue;
    ++tally.used;
    if (waves.directions[v].isZero(0)) {
      ++tally.without_wave;
      continue;
    }
    const double frequency = waves.frequencies[v];
    tally.frequency_sum += frequency;
    tally.frequency_min = std::min(tally.frequency_min, frequency);
    tally.frequency_max = std::max(tally.frequency_max, frequency);
    const double length = mean_length_along(surface, v, waves.directions[v]);
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

namespace {

std::vector<std::string> reasons(const MissingWaves& missing) {
  std::vector<std::string> lines;
  const auto add = [&](std::size_t count, const char* why) {
    if (count > 0) lines.push_back(formatted("%zu vertices have no wave: %s", count, why));
  };
  add(missing.too_far.value_or(0), "they are farther than --max-distance from the field's mesh");
  if (missing.tensor) {
    add(missing.tensor->near_normal, "the tensor's axis is within 15 degrees of the normal");
    add(missing.tensor->isotropic, "the tensor has the same eigenvalue along other axes");
  }
  add(missing.without_frequency.value_or(0), "the array of their frequencies is not finite");
  return lines;
}

void refuse_nothing(const WaveFigures& figures, const std::string& source) {
  if (figures.without_wave < figures.used || figures.used == 0) return;
  std::string why;
  for (const std::string& reason : reasons(figures.missing)) why += "; " + reason;
  throw Error("no vertex has a wave: " + source + " is zero, not finite or normal to the surface " +
              (why.empty() ? "at all of them" : "at all others" + why) +
              "; choose other directions");
}

// Phases of stripes that fine would be rounding errors.
void refuse_noise(const WaveFigures& figures) {
  const double edges = figures.edges_per_period_median;
  if (edges == 0 || edges > kFewestEdgesAtAll) return;
  throw Error(
      formatted("a wave passes %.2g edges a period: nothing can be told of such stripes; ", edges) +
      kRemedies);
}

}  // namespace

void check_waves(const WaveFigures& figures, const std::string& source) {
  refuse_nothing(figures, source);
  refuse_noise(figures);
}

std::string warnings(const WaveFigures& figures, const std::string& source) {
  std::string text;
  for (const std::string& reason : reasons(figures.missing)) text += reason + "\n";
  const std::size_t unexplained = figures.without_wave - figures.missing.total();
  if (static_cast<double>(unexplained) > kMostWithoutWave * static_cast<double>(figures.used)) {
    text += formatted("warning: %zu of %zu vertices have no wave: ", unexplained, figures.used) +
            source + " is zero, not finite or normal to the surface there\n";
  }
  if (is_too_fine(figures)) {
    const double edges = figures.edges_per_period_median;
    text +=
        formatted("warning: at half of the vertices a wave passes %.3g edges a period or fewer; ",
                  edges) +
        "below two, stripes may come out as noise; " + kRemedies + subdivisions_proposed(edges) +
        "\n";
  }
  return text;
}

std::string branch_warning(const WaveFigures& figures, std::size_t branches,
                           std::size_t triangles) {
  if (is_too_fine(figures)) return "";
  if (static_cast<double>(branches) <= kMostBranches * static_cast<double>(triangles)) return "";
  return formatted("warning: stripes begin or end in %zu of %zu triangles; ", branches, triangles) +
         kRemedies + "; or a smoother --field\n";
}

}  // namespace brindle::tool
