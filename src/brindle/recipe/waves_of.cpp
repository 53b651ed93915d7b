#include "brindle/waves_of.h"

#include <cmath>
#include <numbers>
#include <utility>

#include "brindle/array_field.h"
#include "brindle/direction_field.h"
#include "brindle/recipe/field_data.h"
#include "brindle/recipe/wave_report.h"
#include "brindle/waves/direction_graph.h"

namespace brindle {
namespace {

/// The frequencies of the waves; 0 where no wave is possible.
FrequencyField places_of_waves(const WaveInput& found) {
  FrequencyField places = found.frequencies;
  for (Index v = 0; v < places.size(); ++v) {
    if (!std::isfinite(places[v]) || (found.is_near && !found.is_near(v))) places[v] = 0;
  }
  return places;
}

void mark_filled(std::vector<float>& filled, std::size_t count, const auto& is_filled) {
  filled.resize(count);
  for (std::size_t v = 0; v < count; ++v) {
    if (is_filled(v)) filled[v] = 1;
  }
}

void see_frequencies(const WaveSurface& surface, const FrequencySmoothingOptions& options,
                     WaveInput& found, WaveResult& made, const Progress& progress) {
  SmoothedFrequencies seen = surface.smooth_frequencies(found.frequencies, options, progress);
  mark_filled(made.support.filled, seen.frequencies.size(), [&](std::size_t v) {
    return std::isnan(found.frequencies[v]) && !std::isnan(seen.frequencies[v]);
  });
  found.frequencies = std::move(seen.frequencies);
  made.frequency_smoothing = FrequencySmoothingReport{seen.changed_median, seen.filled};
  if (found.frequencies_v.empty()) return;
  found.frequencies_v =
      surface.smooth_frequencies(found.frequencies_v, options, progress).frequencies;
}

void see_field(const WaveSurface& surface, const FieldSmoothingOptions& options,
               const FrequencyField& places, WaveInput& found, WaveResult& made,
               const Progress& progress) {
  auto [field, metrics] =
      surface.smooth_field(found.measured, places, found.last, options, progress);
  found.directions = std::move(field.directions);
  made.seen_field = found.directions;
  made.support.coherence = std::move(field.coherence);
  const std::vector<std::uint8_t>& filled = field.filled;
  mark_filled(made.support.filled, filled.size(), [&](std::size_t v) { return filled[v] != 0; });
  made.smoothing = metrics;
  found.missing.unfilled = unfilled_alone(metrics, found.missing);
}

/// Lines and crosses coincide with themselves turned by 90 and 45 degrees both ways.
bool depends_on_sense(const WaveRequest& request) {
  const float angle = request.smoothing.symmetry == 4 ? 45 : 90;
  return std::remainder(request.turn_deg, angle) != 0;
}

}  // namespace

std::size_t WholeSurface::opposite_edges() const {
  return count_opposite_edges(*surface_.neighborhood, surface_.normals) / 2;
}

std::size_t WholeSurface::drop_waves(DirectionField& directions,
                                     FrequencyField& frequencies) const {
  return drop_waves_without_frequency(directions, frequencies);
}

SmoothedFrequencies WholeSurface::smooth_frequencies(std::span<const float> frequencies,
                                                     const FrequencySmoothingOptions& options,
                                                     const Progress& progress) const {
  return smoothed_frequencies(surface_, frequencies, options, progress);
}

std::pair<SmoothedField, FieldSmoothingMetrics> WholeSurface::smooth_field(
    const MeasuredField& measured, std::span<const float> places, const DirectionField& last,
    const FieldSmoothingOptions& options, const Progress& progress) const {
  FieldSmoothing smoothing(surface_, options, progress.part(0, 0.5));
  SmoothedField field = smoothing.frame(measured, places, {last, {}}, progress.part(0.5, 1));
  return {std::move(field), smoothing.metrics()};
}

WaveSet waves_across(const WaveSet& waves, std::span<const Vec3> normals,
                     std::span<const float> frequencies) {
  WaveSet across = waves;
  across.directions = rotated(across.directions, normals, std::numbers::pi_v<float> / 2);
  if (!frequencies.empty()) across.frequencies.assign(frequencies.begin(), frequencies.end());
  return across;
}

WaveResult waves_of(const WaveSurface& surface, const WaveRequest& request, WaveInput found,
                    const Progress& progress) {
  constexpr double kFrequencies = 0.3;  // of the time
  WaveResult made;
  if (request.frequency_smoothing.periods > 0) {
    see_frequencies(surface, request.frequency_smoothing, found, made,
                    progress.part(0, kFrequencies));
  }
  const FrequencyField places = places_of_waves(found);
  if (surface.any(found.may_have_gaps)) {
    found.missing.without_frequency = surface.drop_waves(found.directions, found.frequencies);
  }
  // A field without directions is rejected later, with the metrics of the waves.
  if (request.smoothing.periods > 0 && surface.any(has_data(found.measured))) {
    see_field(surface, request.smoothing, places, found, made, progress.part(kFrequencies, 1));
  }
  if (request.turn_deg != 0) {
    const float turn = request.turn_deg * std::numbers::pi_v<float> / 180;
    found.directions = rotated(found.directions, surface.normals(), turn);
    if (depends_on_sense(request)) made.turned_apart = surface.opposite_edges();
  }
  made.waves = {surface.positions(), std::move(found.directions), std::move(found.frequencies)};
  made.frequencies_v = std::move(found.frequencies_v);
  made.missing = found.missing;
  return made;
}

}  // namespace brindle
