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

/// Whether it holds on all ranks.
bool everywhere(const PatternSurface& surface, bool holds) {
  return surface.piece ? surface.piece->ranks().every(holds) : holds;
}

}  // namespace

bool same_connectivity(const PatternSurface& a, const PatternSurface& b) {
  if (a.surface == b.surface && a.piece == b.piece) return true;
  if (!a.piece != !b.piece || (a.piece && !a.piece->is_shared_like(*b.piece))) return false;
  return a.surface->mesh.vertex_count() == b.surface->mesh.vertex_count() &&
         a.surface->mesh.triangles == b.surface->mesh.triangles;
}

const StripePattern& PatternSeries::next(const PatternSurface& surface, WaveSet waves,
                                         const SeriesOptions& options, bool follows,
                                         const Progress& progress) {
  const bool fitting = everywhere(surface, fits(surface, options));
  if (fitting && everywhere(surface, has_pattern_of(waves))) {
    surface_ = surface;
    return pattern_;
  }
  try {
    // Restarted, an animator would still have the aggregates of its first frame.
    if (!fitting || !follows) start(surface, options);
    surface_ = surface;
    solve(std::move(waves), progress);
    patterns_followed_ += fitting && follows ? 1 : 0;
  } catch (...) {
    forget();
    throw;
  }
  return pattern_;
}

bool PatternSeries::fits(const PatternSurface& surface, const SeriesOptions& options) const {
  return (animator_ || ranks_animator_) && options == options_ &&
         same_connectivity(surface_, surface);
}

bool PatternSeries::has_pattern_of(const WaveSet& waves) const {
  const FrequencyField& wanted = pattern_.frequencies_wanted.empty() ? pattern_.waves.frequencies
                                                                     : pattern_.frequencies_wanted;
  return waves.positions == pattern_.waves.positions &&
         waves.directions == pattern_.waves.directions && waves.frequencies == wanted;
}

void PatternSeries::start(const PatternSurface& surface, const SeriesOptions& options) {
  forget();
  if (surface.piece) {
    DistributedOptions frames;
    frames.slack = options.slack;
    frames.lambda = options.lambda;
    ranks_animator_.emplace(surface.piece->surface(), frames);
  } else {
    AnimatorOptions frames;
    frames.slack = options.slack;
    frames.lambda = options.lambda;
    animator_.emplace(*surface.surface, frames);
  }
  options_ = options;
  ++solvers_made_;
}

void PatternSeries::forget() {
  animator_.reset();
  ranks_animator_.reset();
}

void PatternSeries::solve(WaveSet waves, const Progress& progress) {
  const auto begin = std::chrono::steady_clock::now();
  const FrameResult frame = solve_frame(waves, progress);
  solve_milliseconds_ = milliseconds_since(begin);
  StripePattern made;
  made.solution.z.assign(frame.z.begin(), frame.z.end());
  made.solution.energy = energy();
  made.waves = std::move(waves);
  if (!frame.frequencies.empty()) {
    made.frequencies_wanted =
        std::exchange(made.waves.frequencies, {frame.frequencies.begin(), frame.frequencies.end()});
    made.frequency_change = frame.frequency_change;
  }
  measure(made);
  pattern_ = std::move(made);
}

FrameResult PatternSeries::solve_frame(const WaveSet& waves, const Progress& progress) {
  const FrameInput input{waves.positions, waves.directions, waves.frequencies};
  return ranks_animator_ ? ranks_animator_->frame(input, progress)
                         : animator_->frame(input, progress);
}

double PatternSeries::energy() const {
  return ranks_animator_ ? ranks_animator_->energy() : animator_->energy();
}

/// Corner phases, those of ghosts as well, and the whole's quality.
void PatternSeries::measure(StripePattern& made) const {
  const Mesh& mesh = surface_.surface->mesh;
  made.corners = corner_phases(mesh.triangles, made.waves, made.solution.z, made.phase_shift);
  made.quality = ranks_animator_ ? ranks_animator_->measure().quality
                                 : measure_quality(mesh, made.waves, made.corners);
}

}  // namespace brindle::paraview
