/// Density of a filter's waves, and warnings about likely mistakes.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include <brindle/measured_field.h>
#include <brindle/phase_graph.h>
#include <brindle/quality.h>
#include <brindle/wave_metrics.h>

#include "pattern_series.h"

namespace brindle::paraview {

/// Collective. The metrics of the whole surface's waves, on every rank.
WaveMetrics wave_metrics(const PatternSurface& surface, const WaveSet& waves);

/// Metrics of a run's waves and patterns, the same on all ranks.
struct RunMetrics {
  WaveMetrics waves;
  std::optional<WaveMetrics> crossing;             ///< of waves across these, if there are others
  PatternQuality quality;                          ///< of two patterns what is worse (`worse_of`)
  std::size_t turned_apart = 0;                    ///< as in WaveResult
  bool measured = false;                           ///< the field is an array, taken as it is
  std::optional<FieldSmoothingMetrics> smoothing;  ///< of an array seen at the scale of its stripes
};

/// The library's warnings in terms of ParaView's panels, a sentence each, and one for waves that
/// are nowhere.
std::vector<std::string> warnings_of(const RunMetrics& metrics, const PatternSurface& surface);

}  // namespace brindle::paraview
