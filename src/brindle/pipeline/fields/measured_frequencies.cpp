#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "brindle/base/parallel.h"
#include "brindle/base/standard.h"
#include "brindle/error.h"
#include "brindle/measured_field.h"
#include "brindle/phases/screened.h"
#include "brindle/pipeline/fields/measured_scale.h"
#include "brindle/pipeline/fields/surface_elements.h"

namespace brindle {
namespace {

constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();

/// Residual of the solver, relative to the deviation of the data from their mean.
constexpr float kLogarithmTolerance = 1e-4f;
constexpr int kMostLogarithmIterations = 2000;

void require_frequencies(bool holds, const std::string& message) {
  if (!holds) throw Error("measured frequencies: " + message);
}

void check(const Surface& surface, std::span<const float> frequencies,
           const FrequencySmoothingOptions& options) {
  check_scale("measured frequencies", options.periods, options.fill);
  require_frequencies(frequencies.size() == surface.mesh.vertex_count(),
                      "there are " + std::to_string(frequencies.size()) + " frequencies for " +
                          std::to_string(surface.mesh.vertex_count()) +
                          " vertices; give one to each");
  require_frequencies(
      ranges::none_of(frequencies, [](float f) { return f < 0 || std::isinf(f); }),
      "frequencies must be finite numbers of 0 or above, or NaN where there is none");
}

/// The logarithms of frequencies. NaN is a hole; a vertex of frequency 0 has no wave.
class Logarithms {
 public:
  Logarithms(const Surface& surface, std::span<const float> frequencies, const Progress& progress)
      : surface_(surface), data_(frequencies) {
    const std::vector<float> stiffness = edge_stiffness(surface, progress);
    graph_ = stiffness_graph(surface, stiffness);
    degrees_ = stiffness_sums(*surface.neighborhood, stiffness);
    areas_ = areas_of_vertices(surface, areas_of_triangles(surface.mesh));
    double sum = 0, weight = 0;
    for (std::size_t i = 0; i < data_.size(); ++i) {
      if (!is_datum(i)) continue;
      sum += static_cast<double>(areas_[i]) * std::log(static_cast<double>(data_[i]));
      weight += static_cast<double>(areas_[i]);
    }
    require_frequencies(weight > 0, "there is none");
    mean_ = static_cast<float>(sum / weight);
    of_data_.assign(data_.size(), 0);
    parallel_for(data_.size(), [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) {
        if (is_datum(i)) of_data_[i] = std::log(data_[i]) - mean_;
      }
    });
    found_.assign(of_data_.begin(), of_data_.end());
  }

  bool is_datum(std::size_t i) const { return data_[i] > 0 && areas_[i] > 0; }
  bool is_hole(std::size_t i) const { return std::isnan(data_[i]); }
  float frequency(std::size_t i) const { return std::exp(found_[i].real() + mean_); }
  float change(std::size_t i) const { return std::abs(found_[i].real() - of_data_[i]); }
  float area(std::size_t i) const { return areas_[i]; }
  std::size_t count() const { return data_.size(); }

  /// Smooths the data over `periods` periods of the current frequencies.
  void smooth(float periods, const Progress& progress) {
    std::vector<float> screening(count());
    graph_.anchor.assign(count(), Complex(0));
    parallel_for(count(), [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) {
        if (!is_datum(i)) continue;
        const float inverse = 2 * frequency(i) / periods;  // of the length l
        screening[i] = areas_[i] * inverse * inverse;
        graph_.anchor[i] = screening[i] * of_data_[i];
      }
    });
    found_ = smooth_screened(graph_, screening, std::move(found_),
                             {.max_iterations = kMostLogarithmIterations,
                              .tolerance = kLogarithmTolerance,
                              .of_anchors = true,
                              .degrees = degrees_,
                              .progress = progress});
  }

  /// Distance of every vertex from the nearest datum, in periods; infinite beyond `reach`.
  std::vector<float> distances(float reach) const {
    std::vector<float> all(count());
    for (Index i = 0; i < count(); ++i) all[i] = frequency(i);
    return periods_from_data(
        surface_, all, [&](Index i) { return is_datum(i); }, [&](Index i) { return is_hole(i); },
        reach);
  }

 private:
  const Surface& surface_;
  std::span<const float> data_;
  PhaseGraph graph_;
  std::vector<float> degrees_, areas_;
  float mean_ = 0;              ///< subtracted, so that the unit of length does not matter
  std::vector<float> of_data_;  ///< logarithms minus mean_; 0 without a datum
  std::vector<Complex> found_;  ///< real
};

/// Median change weighted by area, as a share: 0.1 is 10 percent.
double median_change(const Logarithms& logarithms) {
  std::vector<Index> order;
  double total = 0;
  for (Index i = 0; i < logarithms.count(); ++i) {
    if (!logarithms.is_datum(i)) continue;
    order.push_back(i);
    total += static_cast<double>(logarithms.area(i));
  }
  ranges::sort(order, {}, [&](Index i) { return std::pair(logarithms.change(i), i); });
  double sum = 0;
  for (const Index i : order) {
    sum += static_cast<double>(logarithms.area(i));
    if (sum >= total / 2) return std::expm1(static_cast<double>(logarithms.change(i)));
  }
  return 0;
}

}  // namespace

SmoothedFrequencies smoothed_frequencies(const Surface& surface, std::span<const float> frequencies,
                                         const FrequencySmoothingOptions& options,
                                         const Progress& progress) {
  check(surface, frequencies, options);
  Logarithms logarithms(surface, frequencies, progress.part(0, 0.2));
  // The first pass uses the periods of the noisy data, the second those of the first result.
  logarithms.smooth(options.periods, progress.part(0.2, 0.6));
  logarithms.smooth(options.periods, progress.part(0.6, 1));
  SmoothedFrequencies result;
  result.frequencies.assign(frequencies.begin(), frequencies.end());
  const std::vector<float> distance = logarithms.distances(options.fill);
  for (Index i = 0; i < result.frequencies.size(); ++i) {
    if (logarithms.is_datum(i)) {
      result.frequencies[i] = logarithms.frequency(i);
    } else if (logarithms.is_hole(i)) {
      const bool is_filled = distance[i] <= options.fill;
      result.frequencies[i] = is_filled ? logarithms.frequency(i) : kNaN;
      result.filled += is_filled ? 1 : 0;
    }
  }
  result.changed_median = median_change(logarithms);
  return result;
}

}  // namespace brindle
