/// The state of a filter's run.
#pragma once

#include <brindle/phase_graph.h>
#include <brindle/progress.h>
#include <brindle/waves_of.h>

#include "pattern_series.h"
#include "ranks.h"
#include "surface_cache.h"
#include "vtkBrindleFilter.h"
#include "warnings.h"

struct vtkBrindleFilter::Run {
  brindle::paraview::Ranks ranks;
  const brindle::paraview::InputSurface* input = nullptr;
  brindle::WaveSet waves;
  brindle::FieldSupport support;  ///< of smoothed waves
  float turn_deg = 0;             ///< by which they are turned from their field
  brindle::paraview::RunMetrics metrics;
  brindle::paraview::SeriesOptions options;
  bool follows = false;  ///< whether this time continues the last one
  brindle::paraview::PatternSeries* series = nullptr;
  std::function<brindle::Progress(double, double)> progress;  ///< of a share of the run

  /// Collective. Begins a stage with its share of the progress. If one rank is cancelled, throws
  /// Cancelled on all.
  void begin(double from, double to, const char* stage) const {
    ranks.throw_on_all([&] { progress(from, to).report(stage, 0); });
  }

  brindle::paraview::PatternSurface surface() const {
    return {input->surface, input->piece, input->ids};
  }

  /// Collective. The pattern of the waves.
  const brindle::StripePattern& pattern() {
    const brindle::StripePattern& made =
        series->next(surface(), waves, options, follows, progress(0.4, 0.8));
    metrics.quality = made.quality;
    return made;
  }
};
