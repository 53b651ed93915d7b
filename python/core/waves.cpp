#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "arrays.h"
#include "brindle/array_field.h"
#include "brindle/base/stopwatch.h"
#include "brindle/direction_field.h"
#include "brindle/error.h"
#include "brindle/measured_field.h"
#include "brindle/waves_of.h"
#include "frame_waves.h"
#include "job.h"
#include "pattern_data.h"
#include "words.h"

namespace brindle::python {
namespace {

DirectionField directions_of(const Surface& surface, py::handle given,
                             brindle::PreparationMetrics& prepared) {
  const DirectionsIn in(given, surface.mesh, surface.normals);
  if (in.nonfinite() > 0) prepared.field_rows_nonfinite = in.nonfinite();
  return {in.rows().begin(), in.rows().end()};
}

void drop_waves_without_phase(std::span<const Complex> phases, DirectionField& directions) {
  if (std::ranges::all_of(phases, [](const Complex& z) { return z == Complex(0); })) {
    throw Error("phases: there is none at any vertex; give exp(i Phi) where there is a wave");
  }
  for (std::size_t v = 0; v < phases.size(); ++v) {
    if (phases[v] == Complex(0)) directions[v] = Vec3::Zero();
  }
}

float number_of(const Table& table) { return numbers_of(table.view, "a number").front(); }

void tell_origin(const FieldOrigin& origin, brindle::PreparationMetrics& prepared) {
  prepared.turn_deg = origin.turn_deg;
  if (origin.rows_nonfinite) prepared.field_rows_nonfinite = origin.rows_nonfinite;
  saying_in_pythons_words([&] { brindle::check_wave_report(prepared.metrics, origin.source); });
}

/// The data of a field to smooth.
MeasuredField measured_of(const Surface& surface, const FieldOrigin& origin,
                          const DirectionField& directions) {
  brindle::FieldWeight weight = origin.weight;
  const std::size_t weights = weight.values.size(), vertices = surface.mesh.vertex_count();
  const std::size_t data = origin.data.of_triangles ? surface.mesh.triangle_count() : vertices;
  if (weights != 0 && weights != vertices && weights != data) {
    throw Error("field_weight: expected a row for each of " + std::to_string(vertices) +
                " vertices, got " + std::to_string(weights));
  }
  if (origin.data.of_triangles && weight.values.size() == surface.mesh.vertex_count()) {
    weight.values = brindle::corner_means(surface.mesh, weight.values);
  }
  return brindle::measured_field(origin.data, directions, weight);
}

/// A number, or a row per vertex, possibly with gaps.
void find_frequencies(const Surface& surface, py::handle stripes, py::handle frequency,
                      brindle::WaveInput& found) {
  if (frequency.is_none()) {
    const Table table = table_of(stripes, "stripes");
    if (!table.is_number) throw Error("stripes: expected one number; frequency may be an array");
    found.frequencies = constant_frequency_field(
        frequency_of_stripes(number_of(table), bounding_box(surface.mesh).diagonal()),
        surface.mesh.vertex_count());
    return;
  }
  const FrequenciesIn in(frequency, surface.mesh, "frequency", found.directions);
  found.frequencies.assign(in.rows().begin(), in.rows().end());
  found.may_have_gaps = !in.is_number();
}

/// Frequency smoothing is for arrays only; fields without smoothing are turned here.
brindle::WaveRequest request_of(const FieldOrigin& origin, bool array_of_frequencies) {
  brindle::WaveRequest request{0, origin.smoothing, origin.frequency_smoothing};
  if (origin.smoothing.periods > 0) request.turn_deg = origin.turn_deg;
  if (!array_of_frequencies) request.frequency_smoothing.periods = 0;
  return request;
}

}  // namespace

SmoothedFrequencies seen_frequencies(const Surface& surface, FrequencyField frequencies,
                                     const FieldOrigin& origin) {
  return until_interrupted([&](const Progress& progress) {
    return smoothed_frequencies(surface, frequencies, origin.frequency_smoothing, progress);
  });
}

WavesIn waves_of_arrays(const SurfaceData& data, py::handle directions, py::handle stripes,
                        py::handle frequency, const FieldOrigin& origin,
                        std::span<const Complex> phases) {
  Stopwatch watch;
  const Surface& surface = data.surface;
  WavesIn in;
  in.prepared.vertices_joined = data.vertices_joined;
  in.prepared.load_milliseconds = data.load_milliseconds;
  in.prepared.topology_milliseconds = data.topology_milliseconds;
  brindle::WaveInput found;
  found.directions = directions_of(surface, directions, in.prepared);
  if (!phases.empty()) drop_waves_without_phase(phases, found.directions);
  find_frequencies(surface, stripes, frequency, found);
  if (origin.tensor) {
    found.missing.tensor = brindle::MissingTensorWaves{origin.tensor->first, origin.tensor->second};
  }
  const brindle::WaveRequest request = request_of(origin, found.may_have_gaps);
  brindle::WaveResult made;
  saying_in_pythons_words([&] {
    if (request.smoothing.periods > 0)
      found.measured = measured_of(surface, origin, found.directions);
    made = until_interrupted([&](const Progress& progress) {
      return brindle::waves_of(brindle::WholeSurface(surface), request, std::move(found), progress);
    });
  });
  in.waves = std::move(made.waves);
  in.prepared.support = std::move(made.support);
  static_cast<WaveMetrics&>(in.prepared.metrics) = measure_waves(surface, in.waves);
  in.prepared.metrics.missing = made.missing;
  in.prepared.metrics.turned_apart = made.turned_apart;
  in.prepared.metrics.smoothing = made.smoothing;
  in.prepared.metrics.frequency_smoothing = made.frequency_smoothing;
  in.prepared.metrics.measured = origin.measured;
  if (data.is_points()) in.prepared.metrics.subdivided.reset();
  tell_origin(origin, in.prepared);
  in.prepared.field_milliseconds = origin.milliseconds + watch.lap();
  return in;
}

}  // namespace brindle::python
