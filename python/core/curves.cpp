#include "brindle/curves.h"

#include <numeric>

#include <pybind11/stl.h>

#include "arrays.h"
#include "brindle/curve_measures.h"
#include "brindle/error.h"
#include "brindle/files.h"
#include "brindle/line_drawing.h"
#include "brindle/mesh_data.h"
#include "brindle/recipe/mark_rows.h"
#include "brindle/recipe/refusals.h"
#include "brindle/recipe/report.h"
#include "brindle/samples.h"
#include "brindle/stripe_tracer.h"
#include "job.h"
#include "pattern_data.h"
#include "pictures.h"
#include "stored.h"
#include "words.h"

namespace brindle::python {
namespace {

void check_not_negative(float value, const char* name) {
  if (value >= 0 && std::isfinite(value)) return;
  throw Error(std::string(name) + ": " + std::to_string(value) + "; give 0 or a length above");
}

// Shares of progress.
constexpr double kTraced = 0.7, kResampled = 0.5;

struct CurveRequest {
  CurveOptions traced;
  float offset = 0;
  float min_length = 0;
  std::optional<float> simplify, resample;
};

// Removes short curves after all ends are counted.
void shape_lines(CurvesData& made, const CurveRequest& request, const Progress& progress) {
  made.ends = made.curves.end_counts();
  if (request.min_length > 0 || request.resample || request.simplify) made.traced = made.curves;
  if (request.min_length > 0) {
    const std::size_t all = made.curves.lines.count();
    made.curves = longer_than(made.curves, request.min_length);
    made.short_curves = all - made.curves.lines.count();
  }
  Polylines& lines = made.curves.lines;
  if (request.resample || request.simplify) made.unshaped = lines;
  if (request.resample) lines = resampled(lines, *request.resample, progress.part(0, kResampled));
  if (request.simplify) lines = simplified(lines, *request.simplify, progress.part(kResampled, 1));
}

// Lines about likely mistakes.
std::string warnings_of_curves(const CurvesData& data) {
  return data.curves.lines.count() > 0 ? "" : brindle::why_no_curves("u", data.short_curves);
}

CurveRequest curve_request(const py::dict& options) {
  const GivenOptions given(options);
  CurveRequest request;
  visit_curves(request.traced, given);
  given("--offset", request.offset);
  given("--min-length", request.min_length);
  given("--simplify", request.simplify);
  given("--resample", request.resample);
  return request;
}

CurvesPointer curves(const StripesData& stripes, const py::dict& given) {
  const CurveRequest request = curve_request(given);
  if (stripes.surface->is_points()) throw Error("curves need triangles; points have none");
  check_not_negative(request.min_length, "min_length");
  if (request.simplify) check_not_negative(*request.simplify, "simplify");
  if (!std::isfinite(request.offset)) throw Error("offset: give a finite number of periods");
  return until_interrupted([&](const Progress& progress) {
    auto made = std::make_shared<CurvesData>();
    made->surface = stripes.surface;
    const Surface& surface = stripes.surface->surface;
    const CurveOptions& options = request.traced;
    const Progress tracing = progress.part(0, kTraced);
    if (request.offset == 0) {
      made->curves = stripe_curves(surface, stripes.pattern, options, tracing);
    } else {
      StripePattern moved = stripes.pattern;
      made->jogs = shift_stripes(surface, request.offset, moved);
      made->curves = stripe_curves(surface, moved, options, tracing);
    }
    shape_lines(*made, request, progress.part(kTraced, 1));
    return made;
  });
}

// Pairs of point numbers; closed lines return to their first point.
py::array edges_of(const CurvesData& data) {
  const Polylines& lines = data.curves.lines;
  std::vector<std::int32_t> edges;
  edges.reserve(2 * lines.points.size());
  for (std::size_t line = 0; line < lines.count(); ++line) {
    const auto begin = static_cast<std::int32_t>(lines.offsets[line]);
    const auto end = static_cast<std::int32_t>(lines.offsets[line + 1]);
    for (std::int32_t point = begin; point + 1 < end; ++point) {
      edges.insert(edges.end(), {point, point + 1});
    }
    if (lines.closed[line] != 0 && end - begin > 1) edges.insert(edges.end(), {end - 1, begin});
  }
  const auto count = static_cast<py::ssize_t>(edges.size()) / 2;
  return owned<std::int32_t>(std::move(edges), {count, 2});
}

py::tuple places_of(const CurvesData& data) {
  std::vector<std::int32_t> triangles;
  std::vector<double> weights;
  for (const TrianglePoint& place : data.curves.lines.places) {
    triangles.push_back(static_cast<std::int32_t>(place.triangle));
    weights.insert(weights.end(), place.barycentric.begin(), place.barycentric.end());
  }
  const auto count = static_cast<py::ssize_t>(triangles.size());
  return py::make_tuple(owned(std::move(triangles)), owned<double>(std::move(weights), {count, 3}));
}

py::array ends_of(const CurvesData& data) {
  std::vector<std::uint8_t> ends;
  for (const auto& [first, last] : data.curves.ends) {
    ends.push_back(static_cast<std::uint8_t>(first));
    ends.push_back(static_cast<std::uint8_t>(last));
  }
  const auto count = static_cast<py::ssize_t>(ends.size()) / 2;
  return owned<std::uint8_t>(std::move(ends), {count, 2});
}

py::array lengths_of(const CurvesData& data) {
  std::vector<double> lengths;
  for (std::size_t line = 0; line < data.curves.lines.count(); ++line) {
    lengths.push_back(length_of(data.curves.lines, line));
  }
  return owned(std::move(lengths));
}

py::dict metrics_of(const CurvesData& data) {
  const auto end = [&](CurveEnd kind) { return data.ends[static_cast<std::size_t>(kind)]; };
  const StripeCurves& curves = data.curves;
  const py::dict ends("total"_a = std::accumulate(data.ends.begin(), data.ends.end(), 0UL),
                      "boundary"_a = end(CurveEnd::boundary), "no_wave"_a = end(CurveEnd::no_wave),
                      "nonmanifold"_a = end(CurveEnd::nonmanifold),
                      "crease"_a = end(CurveEnd::crease), "branch"_a = end(CurveEnd::branch),
                      "singularity"_a = end(CurveEnd::singularity));
  return py::dict("short_curves_left_out"_a = data.short_curves, "ends"_a = ends,
                  "joined_ends"_a = curves.joined_ends,
                  "ends_at_neighbours"_a = curves.ends_at_neighbors,
                  "trimmed_ends"_a = curves.trimmed_ends, "trimmed_away"_a = curves.trimmed_away,
                  "smooth_forks"_a = curves.smooth_forks, "largest_move"_a = curves.largest_move,
                  "edges_with_jogs"_a = data.jogs);
}

py::dict dict_of(const CurveLengths& lengths) {
  return py::dict("closed"_a = lengths.closed_length, "open"_a = lengths.open_length,
                  "shortest"_a = lengths.shortest, "mean"_a = lengths.mean,
                  "longest"_a = lengths.longest);
}

py::dict dict_of(const CurveGaps& gaps) {
  return py::dict("measured"_a = gaps.measured, "least"_a = gaps.least, "mean"_a = gaps.mean,
                  "most"_a = gaps.most, "least_ratio"_a = gaps.least_ratio,
                  "mean_ratio"_a = gaps.mean_ratio, "most_ratio"_a = gaps.most_ratio);
}

// Lengths are those of the final curves, gaps those of all traced curves, and coverage that of the
// remaining curves before reshaping.
py::dict measures_of(const CurvesData& data, const StripesData& stripes, double path_width) {
  const Surface& surface = data.surface->surface;
  const StripeCurves& traced = data.traced ? *data.traced : data.curves;
  const Polylines& unshaped = data.unshaped ? *data.unshaped : data.curves.lines;
  std::optional<double> coverage;
  const CurveMeasures measures = until_interrupted([&](const Progress& progress) {
    if (path_width != 0) {
      coverage = curve_coverage(surface.mesh, unshaped, path_width, progress.part(0.7, 1));
    }
    return measure_curves(surface, stripes.pattern, traced, 0, progress.part(0, 0.7));
  });
  py::dict result;
  result["lengths"] = dict_of(curve_lengths(data.curves.lines));
  if (measures.gaps) result["gaps"] = dict_of(*measures.gaps);
  if (coverage) result["coverage"] = *coverage;
  return result;
}

py::tuple tubes_of(const CurvesData& data, float radius, int sides) {
  Mesh mesh = until_interrupted([&](const Progress& progress) {
    return tubes(data.curves.lines, {radius, sides}, progress);
  });
  const auto count = static_cast<py::ssize_t>(mesh.triangles.size());
  return py::make_tuple(owned(std::move(mesh.positions)),
                        owned<std::int32_t>(std::move(mesh.triangles), {count, 3}));
}

// An array of the surface, a row per vertex or triangle, at places on it.
template <class Places>
py::array interpolated(const SurfaceData& surface, const Places& places, const std::string& name,
                       py::handle array, bool axes) {
  const Mesh& mesh = surface.surface.mesh;
  const DataArrays values = surface_array_of(mesh, name, array);
  return array_owning(chosen(arrays_at(places, mesh.triangles, values).front(), axes));
}

// A drawing without hidden lines.
void draw(const CurvesData& data, const std::string& path, const Picture& picture,
          const std::string& color) {
  if (path.ends_with(".pdf")) {
    throw Error("cannot draw '" + path +
                "': a drawing is an .svg here; brindle curves writes .pdf");
  }
  const Surface& surface = data.surface->surface;
  const RenderOptions options = options_relative_to(surface.mesh.origin, picture);
  check_slice_leaves_something(surface.mesh, options);
  const PenLines pen{"u", line_color(picture, color), data.curves.lines};
  until_interrupted([&](const Progress& progress) {
    const std::vector<Pen> drawn =
        line_drawing(surface.mesh, surface.normals, {&pen, 1}, options.camera, options.width,
                     options.height, progress.part(0, 0.8));
    write_svg(path, options.width, options.height, drawn, progress.part(0.8, 1));
  });
}

void bind_curves_class(py::module_& module) {
  py::class_<CurvesData, CurvesPointer> type(module, "Curves");
  bind_pickle(type);
  def_rows(
      type, "local_points", [](const auto& data) -> auto& { return data.curves.lines.points; });
  def_rows(
      type, "normals", [](const auto& data) -> auto& { return data.curves.lines.normals; });
  def_rows(
      type, "offsets", [](const auto& data) -> auto& { return data.curves.lines.offsets; });
  type.def_readonly("surface", &CurvesData::surface)
      .def_property_readonly(
          "closed",
          [](py::handle self) {
            const auto& data = py::cast<const CurvesData&>(self);
            return shared_rows(std::span(data.curves.lines.closed), self).attr("view")("bool");
          })
      .def("edges", edges_of)
      .def("places", places_of)
      .def("ends", ends_of)
      .def("lengths", lengths_of)
      .def("metrics", metrics_of)
      .def("warnings", warnings_of_curves)
      .def("measures", measures_of, py::arg("stripes"), py::arg("path_width"))
      .def("tubes", tubes_of, py::arg("radius"), py::arg("sides"))
      .def(
          "interpolate",
          [](const CurvesData& data, const std::string& name, py::handle array, bool axes) {
            return interpolated(*data.surface, data.curves.lines.places, name, array, axes);
          },
          py::arg("name"), py::arg("array"), py::arg("axes"))
      .def("draw", draw, py::arg("path"), py::arg("picture"), py::arg("color"))
      .def(
          "write",
          [](const CurvesData& data, const std::string& path, const std::string& name,
             const py::dict& arrays) {
            const NamedLines kind{name, data.curves.lines, data_arrays_of(arrays)};
            without_lock([&] { write_polylines(path, std::span(&kind, 1)); });
          },
          py::arg("path"), py::arg("name"), py::arg("arrays"));
}

struct SamplesData {
  SurfacePointer surface;
  std::vector<Sample> samples;
  std::size_t doubles = 0;  // number left out

  static constexpr int kMembers = 3;
};
using SamplesPointer = std::shared_ptr<SamplesData>;

void check_same(const StripesData& u, const StripesData& v) {
  if (u.surface == v.surface) return;
  throw Error("samples: both patterns must be of one surface");
}

SamplesPointer samples(const StripesData& u, const StripesData& v, float min_distance) {
  check_same(u, v);
  check_not_negative(min_distance, "min_distance");
  if (u.surface->is_points()) {
    saying_in_pythons_words([&] { brindle::check_min_distance_on_points(min_distance); });
  }
  return until_interrupted([&](const Progress& progress) {
    constexpr double kEdges = 0.1, kFound = 0.8;
    auto made = std::make_shared<SamplesData>();
    made->surface = u.surface;
    const StripeTracer tracer(u.surface->surface, progress.part(0, kEdges));
    made->samples = tracer.crossings(u.pattern, v.pattern, progress.part(kEdges, kFound));
    made->doubles = drop_doubles(made->samples, min_distance, progress.part(kFound, 1));
    return made;
  });
}

py::array vectors_per_sample(const SamplesData& data, Vec3 Sample::*part) {
  std::vector<Vec3> vectors;
  for (const Sample& sample : data.samples) vectors.push_back(sample.*part);
  return owned(std::move(vectors));
}

py::dict sample_columns(const SamplesData& data) {
  std::vector<float> spacing_u, spacing_v;
  std::vector<std::int32_t> triangles;
  for (const Sample& sample : data.samples) {
    spacing_u.push_back(sample.spacing_u);
    spacing_v.push_back(sample.spacing_v);
    triangles.push_back(static_cast<std::int32_t>(sample.triangle));
  }
  return py::dict("points"_a = vectors_per_sample(data, &Sample::position),
                  "normals"_a = vectors_per_sample(data, &Sample::normal),
                  "directions_u"_a = vectors_per_sample(data, &Sample::direction_u),
                  "directions_v"_a = vectors_per_sample(data, &Sample::direction_v),
                  "barycentric"_a = vectors_per_sample(data, &Sample::barycentric),
                  "spacing_u"_a = owned(std::move(spacing_u)),
                  "spacing_v"_a = owned(std::move(spacing_v)),
                  "triangles"_a = owned(std::move(triangles)));
}

/// As text that Python parses, with the keys of reports.
std::string spacing_of(const SamplesData& data) {
  const SampleSpacing spacing = until_interrupted(
      [&](const Progress& progress) { return measure_sample_spacing(data.samples, progress); });
  return brindle::to_json(spacing).dump();
}

}  // namespace

void bind_curves(py::module_& module) {
  bind_curves_class(module);
  module.def("curves", curves, py::arg("stripes"), py::arg("request"));
  py::class_<SamplesData, SamplesPointer> type(module, "Samples");
  bind_pickle(type);
  type.def_property_readonly("count", [](const SamplesData& data) { return data.samples.size(); })
      .def_readonly("doubles", &SamplesData::doubles)
      .def("columns", sample_columns)
      .def("spacing", spacing_of)
      .def(
          "interpolate",
          [](const SamplesData& data, const std::string& name, py::handle array, bool axes) {
            return interpolated(*data.surface, data.samples, name, array, axes);
          },
          py::arg("name"), py::arg("array"), py::arg("axes"))
      .def(
          "write",
          [](const SamplesData& data, const std::string& path, const py::dict& arrays) {
            const std::vector<DataArray> kept = data_arrays_of(arrays);
            without_lock([&] {
              write_samples(path, data.samples, data.surface->surface.mesh.origin, kept);
            });
          },
          py::arg("path"), py::arg("arrays"));
  module.def("samples", samples, py::arg("u"), py::arg("v"), py::arg("min_distance"));
}

}  // namespace brindle::python
