/// What a run of a filter works with.
#pragma once

#include <brindle/phase_graph.h>
#include <brindle/progress.h>

#include "pattern_series.h"
#include "surface_cache.h"
#include "vtkBrindleFilter.h"

struct vtkBrindleFilter::Run {
  const brindle::paraview::InputSurface* input = nullptr;
  brindle::WaveSet waves;
  brindle::paraview::SeriesOptions options;
  bool follows = false;  ///< whether this time comes after the last one
  brindle::paraview::PatternSeries* series = nullptr;
  std::function<brindle::Progress(double, double)> progress;  ///< of a share of the run

  /// The pattern of the waves.
  const brindle::StripePattern& pattern() {
    return series->next(input->surface, waves, options, follows, progress(0.4, 0.8));
  }
};
