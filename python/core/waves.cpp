#include <algorithm>
#include <cmath>
#include <string>

#include "arrays.h"
#include "brindle/array_field.h"
#include "brindle/base/stopwatch.h"
#include "brindle/direction_field.h"
#include "brindle/error.h"
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
    directions[v] = is_direction(vectors[v], normals[v]) && !normals[v].isZero(0)
                        ? vectors[v]
                        : tangent_direction(vectors[v], normals[v]);
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

FrequencyField frequencies_per_vertex(const Table& table, DirectionField& directions,
                                      brindle::PreparationFigures& prepared) {
  const DataArray array = data_array_of("frequency", table.array);
  check_rows(table, directions.size(), "frequency");
  FrequencyField frequencies = frequencies_of(array, directions);
  prepared.figures.missing.without_frequency =
      drop_waves_without_frequency(directions, frequencies);
  return frequencies;
}

}  // namespace

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
  if (!frequency.is_none()) {
    const Table table = table_of(frequency, "frequency");
    in.waves.frequencies = table.is_number
                               ? constant_frequency_field(number_of(table), mesh.vertex_count())
                               : frequencies_per_vertex(table, in.waves.directions, in.prepared);
  } else {
    const Table table = table_of(stripes, "stripes");
    if (!table.is_number) throw Error("stripes: expected one number; frequency may be an array");
    in.waves.frequencies = constant_frequency_field(
        frequency_of_stripes(number_of(table), bounding_box(mesh).diagonal()), mesh.vertex_count());
  }
  in.prepared.figures = {measure_waves(surface.surface, in.waves), in.prepared.figures.missing};
  tell_origin(origin, in.prepared);
  in.prepared.field_milliseconds = origin.milliseconds + watch.lap();
  return in;
}

}  // namespace brindle::python
