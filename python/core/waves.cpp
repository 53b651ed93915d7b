#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>

#include "arrays.h"
#include "brindle/array_field.h"
#include "brindle/base/stopwatch.h"
#include "brindle/direction_field.h"
#include "brindle/error.h"
#include "brindle/measured_field.h"
#include "job.h"
#include "pattern_data.h"
#include "words.h"

namespace brindle::python {
namespace {

constexpr float kUnitSquare = 1e-5f;
constexpr float kTangentSine = 1e-3f;

bool is_direction(const Vec3& vector, const Vec3& normal) {
  return vector.isZero(0) || (std::abs(vector.squaredNorm() - 1) <= kUnitSquare &&
                              std::abs(vector.dot(normal)) <= kTangentSine);
}

DirectionField directions_of(const SurfaceData& data, py::handle given,
                             brindle::PreparationFigures& prepared) {
  const RowsIn<Vec3> in(given, "directions");
  const std::span<const Vec3> vectors = in.rows();
  const std::vector<Vec3>& normals = data.surface.normals;
  if (vectors.size() != normals.size()) {
    throw Error("directions: there are " + std::to_string(vectors.size()) + " for " +
                std::to_string(normals.size()) + " vertices; give one to each");
  }
  DirectionField directions(vectors.size());
  std::size_t nonfinite = 0;
  for (std::size_t v = 0; v < vectors.size(); ++v) {
    nonfinite += vectors[v].allFinite() ? 0 : 1;
    directions[v] = direction_of(vectors[v], normals[v]);
  }
  if (nonfinite > 0) prepared.field_rows_nonfinite = nonfinite;
  return directions;
}

void drop_waves_without_phase(std::span<const Complex> phases, DirectionField& directions) {
  if (phases.size() != directions.size()) {
    throw Error("phases: there are " + std::to_string(phases.size()) + " for " +
                std::to_string(directions.size()) + " vertices; give one to each");
  }
  if (std::ranges::all_of(phases, [](const Complex& z) { return z == Complex(0); })) {
    throw Error("phases: there is none at any vertex; give exp(i Phi) where there is a wave");
  }
  for (std::size_t v = 0; v < phases.size(); ++v) {
    if (phases[v] == Complex(0)) directions[v] = Vec3::Zero();
  }
}

float number_of(const Table& table) { return numbers_of(table.view, "a number").front(); }

void tell_origin(const FieldOrigin& origin, brindle::PreparationFigures& prepared) {
  prepared.turn_deg = origin.turn_deg;
  if (origin.rows_nonfinite) prepared.field_rows_nonfinite = origin.rows_nonfinite;
  if (origin.tensor) {
    prepared.figures.missing.tensor =
        brindle::MissingTensorWaves{origin.tensor->first, origin.tensor->second};
  }
  saying_in_pythons_words([&] { brindle::check_wave_report(prepared.figures, origin.source); });
}

FrequencyField frequencies_per_vertex(const Surface& surface, const Table& table,
                                      const FieldOrigin& origin, DirectionField& directions,
                                      brindle::PreparationFigures& prepared,
                                      FrequencyField& with_gaps) {
  const DataArray array = data_array_of("frequency", table.array);
  check_rows(table, directions.size(), "frequency");
  FrequencyField frequencies = frequencies_of(array, directions);
  if (origin.frequency_detail.periods > 0) {
    const DetailedFrequencies seen = seen_frequencies(surface, std::move(frequencies), origin);
    frequencies = seen.frequencies;
    prepared.figures.frequency_detail =
        brindle::FrequencyDetailReport{seen.changed_median, seen.filled};
  }
  with_gaps = frequencies;
  prepared.figures.missing.without_frequency =
      drop_waves_without_frequency(directions, frequencies);
  return frequencies;
}

/// The field at the scale of its stripes, turned by what the origin says. `with_gaps` are not
/// finite where there can be no wave.
void see_at_detail(const Surface& surface, const FieldOrigin& origin,
                   const FrequencyField& with_gaps, WavesIn& in) {
  brindle::FieldWeight weight = origin.weight;
  if (origin.data.of_triangles && weight.values.size() == surface.mesh.vertex_count()) {
    weight.values = brindle::corner_means(surface.mesh, weight.values);
  }
  const MeasuredField measured = brindle::measured_field(origin.data, in.waves.directions, weight);
  if (!brindle::has_data(measured)) return;  // figures of the waves say why
  const FrequencyField frequencies =
      brindle::places_of_waves(with_gaps, [](Index) { return true; });
  const auto seen = until_interrupted([&](const Progress& progress) {
    FieldDetail detail(surface, origin.detail, progress.part(0, 0.5));
    DetailedField field = detail.frame(measured, frequencies, {}, progress.part(0.5, 1));
    return std::make_pair(std::move(field), detail.figures());
  });
  const float turn = origin.turn_deg * std::numbers::pi_v<float> / 180;
  in.waves.directions = seen.first.directions;
  if (turn != 0) in.waves.directions = rotated(in.waves.directions, surface.normals, turn);
  in.prepared.agreement = seen.first.agreement;
  in.prepared.figures.detail = seen.second;
  brindle::MissingWaves& missing = in.prepared.figures.missing;
  missing.unfilled = brindle::unfilled_alone(seen.second, missing);
}

}  // namespace

Vec3 direction_of(const Vec3& vector, const Vec3& normal) {
  if (is_direction(vector, normal) && !normal.isZero(0)) return vector;
  return tangent_direction(vector, normal);
}

DetailedFrequencies seen_frequencies(const Surface& surface, FrequencyField frequencies,
                                     const FieldOrigin& origin) {
  return until_interrupted([&](const Progress& progress) {
    return detailed_frequencies(surface, frequencies, origin.frequency_detail, progress);
  });
}

WavesIn waves_of(const SurfaceData& surface, py::handle directions, py::handle stripes,
                 py::handle frequency, const FieldOrigin& origin, std::span<const Complex> phases) {
  Stopwatch watch;
  WavesIn in;
  in.prepared.vertices_joined = surface.vertices_joined;
  in.prepared.load_milliseconds = surface.load_milliseconds;
  in.prepared.topology_milliseconds = surface.topology_milliseconds;
  const Mesh& mesh = surface.surface.mesh;
  in.waves.directions = directions_of(surface, directions, in.prepared);
  in.waves.positions = mesh.positions;
  if (!phases.empty()) drop_waves_without_phase(phases, in.waves.directions);
  FrequencyField with_gaps;  // not finite where there can be no wave
  if (!frequency.is_none()) {
    const Table table = table_of(frequency, "frequency");
    in.waves.frequencies =
        table.is_number ? constant_frequency_field(number_of(table), mesh.vertex_count())
                        : frequencies_per_vertex(surface.surface, table, origin,
                                                 in.waves.directions, in.prepared, with_gaps);
  } else {
    const Table table = table_of(stripes, "stripes");
    if (!table.is_number) throw Error("stripes: expected one number; frequency may be an array");
    in.waves.frequencies = constant_frequency_field(
        frequency_of_stripes(number_of(table), bounding_box(mesh).diagonal()), mesh.vertex_count());
  }
  if (with_gaps.empty()) with_gaps = in.waves.frequencies;
  if (origin.detail.periods > 0) {
    saying_in_pythons_words([&] { see_at_detail(surface.surface, origin, with_gaps, in); });
  }
  static_cast<WaveFigures&>(in.prepared.figures) = measure_waves(surface.surface, in.waves);
  in.prepared.figures.measured = origin.measured;
  tell_origin(origin, in.prepared);
  in.prepared.field_milliseconds = origin.milliseconds + watch.lap();
  return in;
}

}  // namespace brindle::python
