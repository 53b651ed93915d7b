/// Metrics of waves on their surface, and warnings of likely mistakes.
#pragma once

#include <cstddef>
#include <limits>
#include <string>
#include <vector>

#include "brindle/export.h"
#include "brindle/phase_graph.h"
#include "brindle/surface.h"

namespace BRINDLE_EXPORT brindle {

/// Metrics over the vertices with neighbours and a wave. Vertices without neighbours, which no
/// triangle uses, do not count.
struct WaveMetrics {
  std::size_t used = 0;          ///< vertices with neighbours
  std::size_t without_wave = 0;  ///< vertices with neighbours but without a wave
  double frequency_min = 0;      ///< stripes per unit length
  double frequency_max = 0;
  double stripes = 0;  ///< of the mean frequency, along the diagonal of the bounding box
  // Mesh edges per period: the period over the mean length of a vertex's edges along its wave. 0 if
  // no edge runs along any wave.
  double edges_per_period_min = 0;
  double edges_per_period_median = 0;
};

/// `waves` has one entry per vertex.
WaveMetrics measure_waves(const Surface& surface, const WaveSet& waves);

/// Sums over the vertices with an entry in `waves`: those of a part of a surface.
struct WaveTally {
  std::size_t used = 0, without_wave = 0;
  double frequency_sum = 0, frequency_max = 0;
  double frequency_min = std::numeric_limits<double>::infinity();
  std::vector<double> edges_per_period;  ///< of vertices with a wave and an edge along it
};

WaveTally tally_waves(const Surface& surface, const WaveSet& waves);

/// The metrics of a tally, without edges per period; `diagonal` is that of the bounding box.
WaveMetrics metrics_of(const WaveTally& tally, double diagonal);

/// The words of a program for remedies in warnings.
struct WarningWords {
  std::string fewer =
      "take fewer stripes, or a lower frequency, which counts stripes per unit of the mesh's own "
      "length";
  std::string subdivide = "subdivide the mesh, times:";  ///< a number follows; empty: in no way
  int subdivided = 0;                        ///< subdivisions already made, added to that number
  std::string field = "field";               ///< as in "a smoother field"
  std::string source = "the field";          ///< of directions
  std::string smoothing = "FieldSmoothing";  ///< what smooths measured fields to stripe resolution
  std::string singularities = "FieldSmoothingOptions::singularities";  ///< what limits their number
  std::string join = "join them with make_repaired_mesh";              ///< vertices at one place
};

/// Warnings of likely mistakes, one sentence each without a full stop: more than 1 % of the
/// vertices without a wave. Those of stripes that the mesh cannot resolve are `quality_warnings`.
std::vector<std::string> wave_warnings(const WaveMetrics& metrics, const WarningWords& words = {});

/// Throws Error if no vertex has a wave, with `why` after the reason, or if half of them have at
/// most 1e-4 edges per period.
void check_metrics(const WaveMetrics& metrics, const WarningWords& words = {},
                   const std::string& why = {});

}  // namespace brindle
