// Smooth fields, and measured fields, frame by frame.
#include <atomic>
#include <cmath>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>
#include <pybind11/stl.h>

#include "arrays.h"
#include "brindle/error.h"
#include "brindle/measured_field.h"
#include "brindle/recipe/json_text.h"
#include "brindle/recipe/report.h"
#include "brindle/smooth_field.h"
#include "frame_waves.h"
#include "job.h"
#include "pattern_data.h"
#include "words.h"

namespace brindle::python {
namespace {

struct FieldAnimatorData {
  SurfacePointer surface;
  SmoothFieldAnimator animator;
  std::atomic<bool> busy{false};

  FieldAnimatorData(SurfacePointer on, const SmoothFieldAnimatorOptions& options)
      : surface(std::move(on)), animator(until_interrupted([&](const Progress& progress) {
          return SmoothFieldAnimator(surface->surface, options, progress);
        })) {}
};

py::array field_frame(FieldAnimatorData& data, py::handle vertices, py::handle directions,
                      py::handle weights, const py::object& progress) {
  const OneAtATime alone(data.busy, "this animator");
  refuse_masked(vertices, "vertices");
  const Table numbers = table_of(vertices, "vertices");
  const std::size_t count = numbers.is_number ? 1 : numbers.view.rows();
  const Table ways = table_of(directions, "directions");
  const Table strengths = table_of(weights, "weights");
  for (const auto& [table, what] : {std::pair(&ways, "directions"), {&strengths, "weights"}}) {
    if (!table->is_number) check_rows(table->array, count, what, "anchors (vertices)");
  }
  const std::vector<Vec3> vectors = vectors_of(ways.view, "directions");
  const std::vector<float> weight = numbers_of(strengths.view, "weights");
  const auto kind = numbers.array.dtype().kind();
  if (kind == 'f' && numbers.view.rows() > 0) {
    throw py::type_error("vertices: expected whole numbers");
  }
  const py::array_t<std::int64_t, py::array::c_style | py::array::forcecast> numbers_64(
      numbers.array);
  if (numbers.array.ndim() > 1) {
    throw Error("vertices: expected an array (k,), got one of " +
                std::to_string(numbers.array.ndim()) + " dimensions");
  }
  const auto all = static_cast<std::int64_t>(data.surface->surface.mesh.vertex_count());
  std::vector<FieldAnchor> anchors;
  for (std::size_t i = 0; i < count; ++i) {
    const std::int64_t vertex = numbers_64.data()[i];
    if (vertex < 0 || vertex >= all) {
      throw Error("vertices: " + std::to_string(vertex) + " is none of " + std::to_string(all) +
                  ", numbered from 0");
    }
    anchors.push_back(
        {static_cast<Index>(vertex), vectors[i], strengths.is_number ? weight.front() : weight[i]});
  }
  return owned(Job(progress).run([&](const Progress& reports) {
    const std::span<const Vec3> field = data.animator.frame(anchors, reports);
    return std::vector<Vec3>(field.begin(), field.end());
  }));
}

struct FieldSmoothingData {
  SurfacePointer surface;
  FieldSmoothing smoothing;
  DirectionField last;  ///< of the frame before; empty in the first one
  std::vector<std::uint8_t> filled;
  std::atomic<bool> busy{false};

  FieldSmoothingData(SurfacePointer on, const FieldSmoothingOptions& options)
      : surface(std::move(on)), smoothing(surface->surface, options) {}
};

std::unique_ptr<FieldSmoothingData> make_field_smoothing(const SurfacePointer& surface,
                                                         float periods, int symmetry, float fill,
                                                         std::optional<int> singularities,
                                                         float memory, float hold_out) {
  FieldSmoothingOptions options;
  options.periods = periods;
  options.symmetry = symmetry;
  options.fill = fill;
  options.memory = memory;
  options.hold_out = hold_out;
  if (singularities && *singularities < 0) {
    throw Error("singularities: give a number of 0 or above");
  }
  if (singularities) options.singularities = static_cast<std::size_t>(*singularities);
  return std::make_unique<FieldSmoothingData>(surface, options);
}

/// A row per vertex or per triangle.
MeasuredField measured_of(const SurfaceData& surface, py::handle vectors, py::handle confidence) {
  const Mesh& mesh = surface.surface.mesh;
  MeasuredField measured;
  const Table data = table_of(vectors, "vectors");
  measured.of_triangles =
      data.view.rows() != mesh.vertex_count() && data.view.rows() == mesh.triangle_count();
  if (!measured.of_triangles) check_rows(data.array, mesh, "vectors");
  measured.directions = vectors_of(data.view, "vectors");
  const std::vector<Vec3>& normals = surface.surface.normals;
  for (std::size_t i = 0; i < measured.directions.size(); ++i) {
    Vec3& vector = measured.directions[i];
    vector =
        measured.of_triangles ? Vec3(vector.stableNormalized()) : direction_of(vector, normals[i]);
  }
  if (confidence.is_none()) return measured;
  const Table weights = table_of(confidence, "confidence");
  check_rows(weights.array, measured.directions.size(), "confidence", "vectors");
  measured.confidence = numbers_of(weights.view, "confidence");
  for (float& number : measured.confidence) {
    if (!std::isfinite(number)) number = 0;
  }
  return measured;
}

py::tuple field_smoothing_frame(FieldSmoothingData& data, py::handle vectors,
                                py::handle frequencies, py::handle confidence, py::handle last,
                                const py::object& progress) {
  const OneAtATime alone(data.busy, "this smoothing");
  const Mesh& mesh = data.surface->surface.mesh;
  const MeasuredField measured = measured_of(*data.surface, vectors, confidence);
  const Table table = table_of(frequencies, "frequencies");
  if (!table.is_number) check_rows(table.array, mesh, "frequencies");
  FrequencyField waves = numbers_of(table.view, "frequencies");
  if (table.is_number) waves.assign(mesh.vertex_count(), waves.front());
  for (float& frequency : waves) {
    if (!std::isfinite(frequency)) frequency = 0;
  }
  MeasuredField before{data.last, {}};
  if (!last.is_none()) {
    const RowsIn<Vec3> rows(last, mesh, "previous");
    before.directions.assign(rows.rows().begin(), rows.rows().end());
  }
  SmoothedField seen;
  Job(progress).run([&](const Progress& reports) {
    seen = data.smoothing.frame(measured, waves, before, reports);
  });
  data.last = seen.directions;
  data.filled = std::move(seen.filled);
  return py::make_tuple(owned(std::move(seen.directions)), owned(std::move(seen.coherence)));
}

/// As text that Python parses, with the keys of reports.
std::string metrics_of_smoothing(FieldSmoothingData& data) {
  const OneAtATime alone(data.busy, "this smoothing");
  const FieldSmoothingMetrics metrics = data.smoothing.metrics();
  nlohmann::ordered_json json = brindle::to_json(metrics);
  json["field_singularities"] = metrics.singularities;
  return brindle::json_text(json);
}

}  // namespace

void bind_field_animators(py::module_& module) {
  py::class_<FieldAnimatorData>(module, "FieldAnimator")
      .def(py::init([](const SurfacePointer& surface, int symmetry, float lambda, int sweeps) {
             return std::make_unique<FieldAnimatorData>(
                 surface, SmoothFieldAnimatorOptions{symmetry, lambda, sweeps});
           }),
           py::arg("surface").none(false), py::arg("symmetry"), py::arg("stiffness"),
           py::arg("sweeps"))
      .def("frame", field_frame, py::arg("vertices"), py::arg("directions"), py::arg("weights"),
           py::arg("progress"));
  py::class_<FieldSmoothingData>(module, "FieldSmoothing")
      .def(py::init(&make_field_smoothing), py::arg("surface").none(false), py::arg("periods"),
           py::arg("symmetry"), py::arg("fill"), py::arg("singularities"),
           py::arg("temporal_smoothing"), py::arg("hold_out"))
      .def("frame", field_smoothing_frame, py::arg("vectors"), py::arg("frequencies"),
           py::arg("confidence"), py::arg("previous"), py::arg("progress"))
      .def("filled", [](const FieldSmoothingData& data) { return owned(std::vector(data.filled)); })
      .def("metrics", metrics_of_smoothing);
}

}  // namespace brindle::python
