#include <cmath>
#include <numbers>
#include <optional>
#include <tuple>

#include <pybind11/stl.h>

#include "arrays.h"
#include "brindle/array_field.h"
#include "brindle/base/array_numbers.h"
#include "brindle/carried_phases.h"
#include "brindle/direction_field.h"
#include "brindle/error.h"
#include "brindle/files.h"
#include "brindle/frequency_field.h"
#include "brindle/normals.h"
#include "brindle/recipe/field_data.h"
#include "brindle/recipe/refusals.h"
#include "brindle/smooth_field.h"
#include "brindle/strokes.h"
#include "brindle/tensor_field.h"
#include "job.h"
#include "surface_data.h"
#include "words.h"

namespace brindle::python {
namespace {

CurvatureDirection curvature_direction(const std::string& which) {
  return static_cast<CurvatureDirection>(choice("--curvature-direction", which));
}

// (points, radius, strength) of each.
using StrokeTuple = std::tuple<py::object, double, double>;

std::vector<FieldStroke> strokes_of(const std::vector<StrokeTuple>& tuples) {
  std::vector<FieldStroke> strokes;
  for (const auto& [points, radius, strength] : tuples) {
    const std::string what = "strokes[" + std::to_string(strokes.size()) + "].points";
    const Table table = table_of(points, what);
    check_columns(table.view, 3, what);
    const std::vector<double> numbers = doubles_of(table.view);
    FieldStroke stroke{{}, radius, strength};
    for (std::size_t i = 0; i + 2 < numbers.size(); i += 3) {
      stroke.points.emplace_back(numbers[i], numbers[i + 1], numbers[i + 2]);
    }
    strokes.push_back(std::move(stroke));
  }
  return strokes;
}

// Throws Error for options without effect: those that differ from the defaults count as given.
void check_smooth(const SmoothFieldOptions& options, bool points) {
  const SmoothFieldOptions unless_given;
  const brindle::IsGiven given = [&](const std::string& option) {
    if (option == "--curvature-direction") {
      return options.curvature_direction != unless_given.curvature_direction;
    }
    if (option == "--feature-angle") {
      return options.feature_angle_deg != unless_given.feature_angle_deg;
    }
    if (option == "--feature-radius") {
      return options.feature_radius != unless_given.feature_radius;
    }
    return option == "--feature-anchor" && options.feature_anchor != unless_given.feature_anchor;
  };
  saying_in_pythons_words([&] {
    check_number("--curvature-anchor", options.curvature_anchor);
    check_number("--feature-anchor", options.feature_anchor);
    check_number("--feature-angle", options.feature_angle_deg);
    brindle::check_smooth_field(given, options.curvature_anchor, options.feature_anchor);
    if (points) brindle::check_triangle_options(given);
  });
}

// (surface, directions, max_distance, match) of the last field; match is empty, "number" or
// "position".
using LastTuple = std::tuple<SurfacePointer, py::object, double, std::string>;

DirectionField last_directions_of(const LastTuple& last) {
  const Surface& surface = std::get<0>(last)->surface;
  const RowsIn<Vec3> rows(std::get<1>(last), surface.mesh, "previous");
  return tangent_directions(rows.rows(), surface.normals);
}

DirectionField carried_last(const LastTuple& last, const DirectionField& directions,
                            const Surface& surface, int symmetry) {
  const Surface& before = std::get<0>(last)->surface;
  const LastField field{before.mesh, before.normals, directions};
  if (matches_by_number(before.mesh, surface.mesh, std::get<3>(last))) {
    return matched_directions(field, surface);
  }
  return carried_directions(field, surface, symmetry, std::get<2>(last));
}

// The field, and its mean turn from the last one in degrees, or None.
py::tuple smooth_field(const SurfaceData& data, int symmetry, float curvature_anchor,
                       const std::string& curvature, float feature_anchor, float feature_angle,
                       float feature_radius, float normal_radius,
                       const std::vector<StrokeTuple>& tuples,
                       const std::optional<LastTuple>& last) {
  SmoothFieldOptions options;
  options.symmetry = symmetry;
  options.curvature_anchor = curvature_anchor;
  options.curvature_direction = curvature_direction(curvature);
  options.feature_anchor = feature_anchor;
  options.feature_angle_deg = feature_angle;
  options.feature_radius = feature_radius;
  options.normal_radius = normal_radius;
  check_smooth(options, data.is_points());
  const std::vector<FieldStroke> strokes = strokes_of(tuples);
  std::optional<double> turned_deg;
  DirectionField last_directions;
  if (last) last_directions = last_directions_of(*last);
  DirectionField field = until_interrupted([&](const Progress& progress) {
    constexpr double kStrokes = 0.2;
    if (!strokes.empty()) {
      options.anchors = stroke_anchors(data.surface, strokes, progress.part(0, kStrokes));
    }
    if (last)
      options.last.directions = carried_last(*last, last_directions, data.surface, symmetry);
    DirectionField found =
        smooth_direction_field(data.surface, options, progress.part(kStrokes, 1));
    if (last) turned_deg = field_step(found, options.last.directions, symmetry).mean_deg;
    return found;
  });
  return py::make_tuple(owned(std::move(field)), turned_deg);
}

py::tuple anchors_of_strokes(const SurfaceData& data, const std::vector<StrokeTuple>& tuples) {
  const std::vector<FieldStroke> strokes = strokes_of(tuples);
  std::vector<std::int32_t> vertices;
  std::vector<Vec3> directions;
  std::vector<float> weights;
  for (const FieldAnchor& anchor : until_interrupted([&](const Progress& progress) {
         return stroke_anchors(data.surface, strokes, progress);
       })) {
    vertices.push_back(static_cast<std::int32_t>(anchor.vertex));
    directions.push_back(anchor.direction);
    weights.push_back(anchor.weight);
  }
  return py::make_tuple(owned(std::move(vertices)), owned(std::move(directions)),
                        owned(std::move(weights)));
}

py::list strokes_in(const std::string& path) {
  py::list result;
  for (const FieldStroke& stroke : read_strokes(path)) {
    std::vector<double> numbers;
    for (const Eigen::Vector3d& point : stroke.points) {
      numbers.insert(numbers.end(), point.data(), point.data() + 3);
    }
    const auto count = static_cast<py::ssize_t>(stroke.points.size());
    result.append(py::make_tuple(owned<double>(std::move(numbers), {count, 3}), stroke.radius,
                                 stroke.strength));
  }
  return result;
}

py::array projected_field(const SurfaceData& data, float x, float y, float z) {
  return owned(projected_direction_field({x, y, z}, data.surface.normals));
}

py::array raw_curvature_field(const SurfaceData& data, const std::string& which) {
  const CurvatureDirection direction = curvature_direction(which);
  const Surface& surface = data.surface;
  return owned(until_interrupted([&](const Progress& progress) {
    DirectionField directions =
        curvature_direction_field(principal_curvatures(surface.mesh.positions, surface.normals,
                                                       *surface.neighborhood, progress),
                                  direction);
    orient_alike(*surface.neighborhood, directions);  // as in the tool, because solvers are faster
    return directions;
  }));
}

py::tuple array_field(const SurfaceData& data, const std::string& name, py::handle vectors) {
  const DataArray array = data_array_of(name, vectors, data.surface.mesh);
  return py::make_tuple(owned(direction_field_of(data.surface, array)), nonfinite_rows(array));
}

py::tuple tensor_field(const SurfaceData& data, const std::string& name, py::handle tensors,
                       const std::string& axis, const std::string& order) {
  const DataArray array = in_vtk_order(data_array_of(name, tensors, data.surface.mesh),
                                       static_cast<TensorOrder>(choice("--tensor-order", order)));
  TensorField field =
      tensor_field_of(data.surface, array, static_cast<TensorAxis>(choice("--tensor", axis)));
  return py::make_tuple(owned(std::move(field.directions)), nonfinite_rows(array),
                        field.near_normal, field.isotropic, field.not_symmetric);
}

py::array rotate_field(const SurfaceData& data, py::handle directions, float degrees) {
  const RowsIn<Vec3> rows(directions, data.surface.mesh, "directions");
  if (!std::isfinite(degrees))
    throw Error("degrees: give a finite number, not " + std::to_string(degrees));
  const float radians = degrees * std::numbers::pi_v<float> / 180;
  return owned(rotated(rows.rows(), data.surface.normals, radians));
}

py::array frequencies_by_array(const SurfaceData& data, const std::string& name, py::handle array,
                               float frequency, std::pair<float, float> range, bool inverse) {
  return owned(frequencies_by(data.surface, data_array_of(name, array, data.surface.mesh),
                              frequency, {range.first, range.second, inverse}));
}

py::array vectors_on_globe(const SurfaceData& data, py::handle east_north) {
  const DataArray vectors = brindle::globe_vectors(
      data.surface.mesh, data_array_of("east_north", east_north, data.surface.mesh));
  return owned(vectors_of(vectors.view(), "vectors"));
}

float stripes_to_frequency(const SurfaceData& data, float stripes) {
  return frequency_of_stripes(stripes, bounding_box(data.surface.mesh).diagonal());
}

}  // namespace

bool matches_by_number(const Mesh& last, const Mesh& mesh, const std::string& match) {
  if (match.empty()) {
    return last.vertex_count() == mesh.vertex_count() && last.triangles == mesh.triangles;
  }
  if (match == "number") return true;
  if (match == "position") return false;
  throw Error("match: '" + match + "' is neither 'number' nor 'position'");
}

void bind_fields(py::module_& module) {
  module.def("smooth_field", smooth_field, py::arg("surface"), py::arg("symmetry"),
             py::arg("curvature_anchor"), py::arg("curvature"), py::arg("feature_anchor"),
             py::arg("feature_angle"), py::arg("feature_radius"), py::arg("normal_radius"),
             py::arg("strokes"), py::arg("last").none(true));
  module.def("stroke_anchors", anchors_of_strokes, py::arg("surface"), py::arg("strokes"));
  module.def("read_strokes", strokes_in, py::arg("path"));
  module.def(
      "write_strokes",
      [](const std::string& path, const std::vector<StrokeTuple>& strokes) {
        write_strokes(path, strokes_of(strokes));
      },
      py::arg("path"), py::arg("strokes"));
  module.def("projected_field", projected_field, py::arg("surface"), py::arg("x"), py::arg("y"),
             py::arg("z"));
  module.def("raw_curvature_field", raw_curvature_field, py::arg("surface"), py::arg("which"));
  module.def("array_field", array_field, py::arg("surface"), py::arg("name"), py::arg("vectors"));
  module.def(
      "nonfinite_rows",
      [](py::handle array) { return nonfinite_rows(data_array_of("array", array)); },
      py::arg("array"));
  module.def("tensor_field", tensor_field, py::arg("surface"), py::arg("name"), py::arg("tensors"),
             py::arg("axis"), py::arg("order") = "vtk");
  module.def("rotate_field", rotate_field, py::arg("surface"), py::arg("directions"),
             py::arg("degrees"));
  module.def("frequencies_by", frequencies_by_array, py::arg("surface"), py::arg("name"),
             py::arg("array"), py::arg("frequency"), py::arg("range"), py::arg("inverse"));
  module.def("globe_vectors", vectors_on_globe, py::arg("surface"), py::arg("east_north"));
  module.def("frequency_of_stripes", stripes_to_frequency, py::arg("surface"), py::arg("stripes"));
  module.def("frequency_of_spacing", frequency_of_spacing, py::arg("spacing"));
}

}  // namespace brindle::python
