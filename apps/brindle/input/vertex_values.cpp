#include "input/vertex_values.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "brindle/base/array_numbers.h"
#include "brindle/base/text.h"
#include "brindle/error.h"
#include "brindle/files.h"
#include "brindle/normals.h"
#include "brindle/surface_tones.h"
#include "cli/option_values.h"
#include "input/array_source.h"
#include "input/csv_field.h"

namespace brindle::tool {

Camera camera_of(const Viewpoint& viewpoint, const Mesh& mesh) {
  const Mesh& framed = viewpoint.framed ? *viewpoint.framed : mesh;
  std::vector<Vec3> points =
      framed.triangles.empty() ? framed.positions : points_of_triangles(framed);
  const Vec3 offset = (framed.origin - mesh.origin).cast<float>();
  for (Vec3& point : points) point += offset;
  CameraView view = viewpoint.view;
  if (view.slice && !view.slice->in_shares) view.slice->point -= mesh.origin;
  return framed_camera(points, view, viewpoint.width, viewpoint.height);
}

bool has_camera(const CLI::App& command) {
  return command.get_option_no_throw("--camera") != nullptr;
}

namespace {

constexpr std::string_view kDistance = "distance:";
constexpr std::string_view kCameraDistance = "distance:camera";
constexpr std::string_view kHeight = "height";
constexpr std::string_view kLight = "light";
constexpr std::string_view kCoherence = "coherence";
constexpr float kNone = std::numeric_limits<float>::quiet_NaN();

bool is_csv(const std::string& text) { return csv_field_name(text).path.ends_with(".csv"); }

/// Selects the rows of the used vertices from a file with rows for others.
DataArray rows_of_vertices(const DataArray& column, std::size_t vertices,
                           std::span<const Index> vertex_of_row) {
  if (vertex_of_row.size() != column.rows() || column.rows() == vertices) return column;
  std::vector<Index> row_of_vertex(vertices, 0);
  for (std::size_t row = column.rows(); row-- > 0;) {
    row_of_vertex[vertex_of_row[row]] = static_cast<Index>(row);
  }
  return rows_of(column, row_of_vertex);
}

}  // namespace

std::vector<float> scalar_values(const std::string& option, const DataArray& array,
                                 std::size_t vertices, const std::string& file) {
  if (array.rows() != vertices) {
    throw Error(file + ": '" + array.name + "' has " + std::to_string(array.rows()) +
                " rows for the " + std::to_string(vertices) + " vertices of the mesh");
  }
  if (array.components != 1 && array.components != 3) {
    throw Error(option + ": '" + array.name + "' has " + std::to_string(array.components) +
                " numbers in a row; take an array of one, or of three, whose length counts");
  }
  const std::vector<double> numbers = doubles_of(array.axes());
  const auto columns = static_cast<std::size_t>(array.components);
  std::vector<float> values(vertices);
  for (std::size_t v = 0; v < vertices; ++v) {
    double value = numbers[columns * v];
    if (columns == 3) value = std::hypot(value, numbers[3 * v + 1], numbers[3 * v + 2]);
    values[v] = std::isfinite(value) ? static_cast<float>(value) : kNone;
    if (!std::isinf(values[v])) continue;
    throw Error(option + ": '" + array.name + "' is " + formatted("%g", value) + " at vertex " +
                std::to_string(v) + "; numbers reach up to 3.4e38, take a larger unit");
  }
  return values;
}

VertexValues csv_values(const std::string& option, const std::string& text, std::size_t vertices,
                        std::span<const Index> vertex_of_row) {
  const CsvFieldName name = csv_field_name(text);
  const DataArrays arrays{read_csv_arrays(name.path), {}};
  if (name.array.empty() && arrays.points.size() != 1) {
    throw Error(name.path + " has several columns: " + list_of(arrays.points) +
                "; choose one: " + name.path + ":" + arrays.points.front().name);
  }
  const std::string column = name.array.empty() ? arrays.points.front().name : name.array;
  const DataArray array =
      rows_of_vertices(array_named(arrays, column, name.path), vertices, vertex_of_row);
  return {scalar_values(option, array, vertices, name.path), column};
}

namespace {

VertexValues array_values(const std::string& option, const std::string& text,
                          const ValueSource& source) {
  const std::string name = parse_array(option, text);
  const ArraySource arrays(source.surface, source.arrays, source.file, source.options);
  const DataArray array = arrays.array(name).array;
  return {scalar_values(option, array, source.surface.mesh.vertex_count(), source.file), name};
}

VertexValues distances_to(const Vec3& place, const Surface& surface, std::string title) {
  VertexValues result{{}, std::move(title)};
  for (const Vec3& position : surface.mesh.positions) {
    result.values.push_back((position - place).norm());
  }
  return result;
}

VertexValues curvatures(const Surface& surface) {
  VertexValues result{{}, "curvature"};
  for (const PrincipalCurvature& c :
       principal_curvatures(surface.mesh.positions, surface.normals, *surface.neighborhood)) {
    result.values.push_back(c.maximum_direction.isZero(0) ? kNone : c.maximum);
  }
  return result;
}

/// The title mentions the axis if it is not the picture's up axis.
VertexValues heights(const Surface& surface, const Viewpoint* viewpoint) {
  const UpAxis axis = viewpoint != nullptr ? viewpoint->height_axis : UpAxis::z;
  const bool differs = viewpoint != nullptr && viewpoint->view.up != axis;
  VertexValues result{{}, differs ? "height (z)" : "height"};
  const Vec3 up = upright_axes(axis).row(1);
  // As the file has it.
  const auto ground = static_cast<float>(up.cast<double>().dot(surface.mesh.origin));
  for (const Vec3& position : surface.mesh.positions) {
    result.values.push_back(ground + up.dot(position));
  }
  return result;
}

VertexValues coherence_values(const std::string& option, const ValueSource& source) {
  if (source.coherence.empty()) {
    throw CLI::ValidationError(
        option,
        "there is no 'coherence' of data here; pictures of a measured field have it, with "
        "--field-smoothing");
  }
  return {{source.coherence.begin(), source.coherence.end()}, std::string(kCoherence)};
}

/// Values that depend on a picture.
VertexValues values_of_camera(const std::string& option, const std::string& text,
                              const ValueSource& source) {
  if (source.viewpoint == nullptr) {
    throw Error(option + ": '" + text + "' depends on a picture's camera, and there is none here");
  }
  const Surface& surface = source.surface;
  const Camera camera = camera_of(*source.viewpoint, surface.mesh);
  if (text == kCameraDistance) return distances_to(eye_of(camera), surface, "distance");
  const PictureLight light{source.viewpoint->view.up, source.viewpoint->light_from};
  return {surface_tones(surface.mesh, surface.normals, camera, light), std::string(kLight)};
}

}  // namespace

Eigen::Vector2f VertexValues::range(const std::string& option) const {
  if (ends) return *ends;
  Eigen::Vector2f range(std::numeric_limits<float>::max(), std::numeric_limits<float>::lowest());
  for (const float value : values) {
    if (std::isfinite(value)) range = {std::min(range[0], value), std::max(range[1], value)};
  }
  if (range[0] > range[1]) {
    throw Error(option + ": there are no values: '" + title + "' is not a number at any vertex");
  }
  return range;
}

void check_value_name(const std::string& option, const std::string& text,
                      const std::string& names) {
  if (is_array(text)) {
    parse_array(option, text);
  } else if (text.starts_with(kDistance)) {
    const std::string place = text.substr(kDistance.size());
    if (place != "camera") parse_place(option, place);
  } else if (text != "curvature" && text != kHeight && text != kLight && text != kCoherence &&
             !is_csv(text)) {
    const bool has_end = text.find('@') != text.npos;
    wrong_usage(option, "one of " + names + (has_end ? ", then a range if any: @A..B" : ""), text);
  }
}

bool is_of_file(const std::string& text) { return is_array(text) || is_csv(text); }

bool depends_on_camera(const std::string& text) {
  return text == kCameraDistance || depends_on_light(text);
}

bool depends_on_light(const std::string& text) { return text == kLight; }

bool depends_on_up(const std::string& text) { return text == kHeight || depends_on_camera(text); }

bool depends_on_field(const std::string& text) { return text == kCoherence; }

std::string value_file(const std::string& text) {
  return !is_array(text) && is_csv(text) ? csv_field_name(text).path : std::string();
}

namespace {

VertexValues values_at_all(const std::string& option, const std::string& text,
                           const ValueSource& source) {
  const Surface& surface = source.surface;
  if (is_array(text)) return array_values(option, text, source);
  if (text == "curvature") return curvatures(surface);
  if (text == kHeight) return heights(surface, source.viewpoint);
  if (depends_on_field(text)) return coherence_values(option, source);
  if (depends_on_camera(text)) return values_of_camera(option, text, source);
  if (text.starts_with(kDistance)) {
    // In file coordinates; positions are relative to the mesh's origin.
    const Eigen::Vector3d relative =
        parse_place(option, text.substr(kDistance.size())) - surface.mesh.origin;
    return distances_to(relative.cast<float>(), surface, "distance");
  }
  VertexValues values = csv_values(option, text, surface.own_vertex_count(), source.vertex_of_row);
  add_rows_of_copies(surface.creases, values.values);
  return values;
}

}  // namespace

VertexValues vertex_values(const std::string& option, const std::string& text,
                           const ValueSource& source) {
  VertexValues values = values_at_all(option, text, source);
  // Vertices without triangles are not drawn. On a partition, its rank knows which these are.
  const Adjacency* neighborhood = source.surface.neighborhood.get();
  for (Index v = 0; neighborhood != nullptr && v < values.values.size(); ++v) {
    if (neighborhood->of(v).empty()) values.values[v] = kNone;
  }
  return values;
}

}  // namespace brindle::tool
