#include "pattern_series.h"

#include <chrono>
#include <utility>

#include <brindle/corner_phases.h>
#include <brindle/quality.h>

namespace brindle::paraview {
namespace {

double milliseconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start)
      .count();
}

}  // namespace

bool same_connectivity(const Surface& a, const Surface& b) {
  return a.mesh.vertex_count() == b.mesh.vertex_count() && a.mesh.triangles == b.mesh.triangles;
}

const StripePattern& PatternSeries::next(std::shared_ptr<const Surface> surface, WaveSet waves,
                                         const SeriesOptions& options, bool follows,
                                         const Progress& progress) {
  const bool fitting = fits(*surface, options);
  if (fitting && has_pattern_of(waves)) {
    surface_ = std::move(surface);
    return pattern_;
  }
  try {
    // Restarted, an animator would still have the aggregates of its first frame.
    if (!fitting || !follows) start(*surface, options);
    surface_ = std::move(surface);
    solve(std::move(waves), progress);
    patterns_followed_ += fitting && follows ? 1 : 0;
  } catch (...) {
    animator_.reset();
    throw;
  }
  return pattern_;
}

bool PatternSeries::fits(const Surface& surface, const SeriesOptions& options) const {
  return animator_ && options == options_ &&
         (surface_.get() == &surface || same_connectivity(*surface_, surface));
}

bool PatternSeries::has_pattern_of(const WaveSet& waves) const {
  const FrequencyField& wanted = pattern_.frequencies_wanted.empty() ? pattern_.waves.frequencies
                                                                     : pattern_.frequencies_wanted;
  return waves.positions == pattern_.waves.positions &&
         waves.directions == pattern_.waves.directions && waves.frequencies == wanted;
}

void PatternSeries::start(const Surface& surface, const SeriesOptions& options) {
  AnimatorOptions frames;
  frames.slack = options.slack;
  frames.lambda = options.lambda;
  animator_.reset();
  animator_.emplace(surface, frames);
  options_ = options;
  ++solvers_made_;
}

void PatternSeries::solve(WaveSet waves, const Progress& progress) {
  const auto begin = std::chrono::steady_clock::now();
  const FrameResult frame =
      animator_->frame({waves.positions, waves.directions, waves.frequencies}, progress);
  solve_milliseconds_ = milliseconds_since(begin);
  StripePattern made;
  made.solution.z.assign(frame.z.begin(), frame.z.end());
  made.solution.energy = animator_->energy();
  made.waves = std::move(waves);
  if (!frame.frequencies.empty()) {
    made.frequencies_wanted =
        std::exchange(made.waves.frequencies, {frame.frequencies.begin(), frame.frequencies.end()});
    made.frequency_change = frame.frequency_change;
  }
  made.corners =
      corner_phases(surface_->mesh.triangles, made.waves, made.solution.z, made.phase_shift);
  made.quality = measure_quality(surface_->mesh, made.waves, made.corners);
  pattern_ = std::move(made);
}

}  // namespace brindle::paraview
