#include "input/make_waves.h"

#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "brindle/array_field.h"
#include "brindle/base/array_rows.h"
#include "brindle/direction_field.h"
#include "brindle/error.h"
#include "brindle/files.h"
#include "brindle/normals.h"
#include "brindle/recipe/field_data.h"
#include "brindle/tensor_field.h"
#include "cli/command_line.h"
#include "input/array_source.h"
#include "input/csv_field.h"

namespace brindle::tool {

WholeSource::WholeSource(const Surface& surface, FileData data, const ArrayOptions& options,
                         std::shared_ptr<const ArraySource> arrays)
    : surface_(surface),
      waves_(surface),
      data_(std::move(data)),
      options_(options),
      arrays_(std::move(arrays)) {
  if (arrays_) return;
  arrays_ = std::make_shared<const ArraySource>(surface, data_.arrays, data_.name, options);
}

std::vector<DataArray> WholeSource::rows(const std::string&, const std::string&,
                                         const ReadRows& read) const {
  std::vector<DataArray> arrays = read(surface_.own_vertex_count(), data_.vertex_of_row);
  for (DataArray& array : arrays) array = with_copies(surface_, array);
  return arrays;
}

std::size_t WholeSource::nonfinite_rows(const DataArray& array) const {
  return brindle::nonfinite_rows(array);
}

VertexValues WholeSource::values(const std::string& option, const std::string& text) const {
  return vertex_values(
      option, text,
      {surface_, data_.arrays, data_.name, options_, data_.vertex_of_row, data_.viewpoint});
}

DirectionField WholeSource::smooth_field(const SmoothFieldOptions& options,
                                         const Progress& progress) const {
  return smooth_direction_field(surface_, options, progress);
}

DirectionField WholeSource::curvature_field(CurvatureDirection direction,
                                            const Progress& progress) const {
  const auto curvatures = principal_curvatures(surface_.mesh.positions, surface_.normals,
                                               *surface_.neighborhood, progress.part(0, 0.6));
  DirectionField directions = curvature_direction_field(curvatures, direction);
  // Solvers are faster if few adjacent directions are opposite.
  orient_alike(*surface_.neighborhood, directions, progress.part(0.6, 1));
  return directions;
}

std::vector<FieldStroke> WholeSource::strokes_of_file(const std::string& path) const {
  return read_strokes(path);
}

std::vector<FieldAnchor> WholeSource::anchors(std::span<const FieldStroke> strokes,
                                              const Progress& progress) const {
  return stroke_anchors(surface_, strokes, progress);
}

DirectionField WholeSource::vector_field(const DataArray& vectors, bool signs) const {
  return direction_field_of(surface_, vectors, signs);
}

TensorField WholeSource::tensor_field(const DataArray& tensors, TensorAxis axis) const {
  return tensor_field_of(surface_, tensors, axis);
}

FrequencyField WholeSource::frequencies_by(const DataArray& values, float frequency,
                                           const FrequencyRange& range) const {
  return brindle::frequencies_by(surface_, values, frequency, range);
}

WaveMetrics WholeSource::measure(const WaveSet& waves) const {
  return measure_waves(surface_, waves);
}

namespace {

using Field = BaseField;

Field tensor_field(const WaveSource& source, const DataArray& array, const ArrayOptions& options) {
  TensorField tensor = source.tensor_field(array, options.tensor.value_or(TensorAxis::major));
  Field field{{std::move(tensor.directions), {}, {}}};
  field.missing.tensor = MissingTensorWaves{tensor.near_normal, tensor.isotropic};
  if (!options.tensor) {
    field.notes += "the array '" + array.name +
                   "' is a tensor: waves run along its major axis; --tensor chooses\n";
  }
  if (tensor.not_symmetric > 0) {
    field.notes += "at " + std::to_string(tensor.not_symmetric) + " vertices the tensor '" +
                   array.name + "' is not symmetric: its symmetric part counts\n";
  }
  return field;
}

[[noreturn]] void refuse_tensor(const std::string& why) {
  throw CLI::ValidationError("--tensor", "has no effect here: " + why);
}

Field array_field(const WaveSource& source, const DataArray& given, const WaveOptions& options) {
  DataArray array;
  source.check([&] {
    array = ordered_array(given, options.arrays);
    if (is_tensor(array) || !options.arrays.tensor) return;
    refuse_tensor("the array '" + array.name + "' has " + std::to_string(array.components) +
                  " numbers in a row, and is no tensor");
  });
  Field field;
  if (is_tensor(array)) {
    field = tensor_field(source, array, options.arrays);
  } else {
    field.directions = source.vector_field(array, has_signs(options));
  }
  field.rows_nonfinite = source.nonfinite_rows(array);
  field.data.array = std::move(array);
  return field;
}

/// A field file: the field, then frequencies.
struct FieldColumns {
  bool named = false;     ///< an array that may be a tensor or vectors
  bool of_globe = false;  ///< east and north components
};

std::vector<DataArray> read_columns(const CsvFieldName& name, const WaveOptions& options,
                                    std::size_t vertices, std::span<const Index> vertex_of_row,
                                    FieldColumns& kind) {
  std::vector<DataArray> columns;
  if (std::optional<CsvField> csv = read_csv_field(name)) {
    kind = {true, csv->of_globe};
    check_rows_per_vertex(csv->array, vertices);
    columns.push_back(std::move(csv->array));
    if (csv->frequency) columns.push_back(std::move(*csv->frequency));
    return columns;
  }
  if (options.arrays.tensor) refuse_tensor("the field '" + name.path + "' has vectors alone");
  const FieldFile file = read_field_csv(name.path, vertices, vertex_of_row);
  columns.push_back(make_data_array("vectors", std::span<const Vec3>(file.vectors)));
  for (const std::vector<float>* numbers : {&file.frequencies, &file.frequencies_v}) {
    if (!numbers->empty()) columns.push_back(make_data_array("frequency", 1, *numbers));
  }
  return columns;
}

Field file_field(const WaveSource& source, const WaveOptions& options) {
  const CsvFieldName name = csv_field_name(options.field);
  FieldColumns kind;
  std::vector<DataArray> columns = source.rows(
      "--field", name.path, [&](std::size_t vertices, std::span<const Index> vertex_of_row) {
        return read_columns(name, options, vertices, vertex_of_row, kind);
      });
  if (source.surface().any(kind.of_globe)) {
    const GlobeRadii radii = source.globe_radii();
    source.check([&] { columns[0] = globe_vectors(source.mesh(), columns[0], radii); });
  }
  if (source.surface().any(kind.named)) {
    Field field = array_field(source, columns[0], options);
    if (columns.size() == 1) return field;
    source.check([&] { field.frequencies = frequencies_of(columns[1], field.directions); });
    field.may_have_gaps = true;
    return field;
  }
  Field field;
  field.directions =
      tangent_directions(vectors_of(columns[0].view(), "vectors"), source.surface().normals());
  field.rows_nonfinite = source.nonfinite_rows(columns[0]);
  if (columns.size() > 1) field.frequencies = numbers_of(columns[1].view(), "frequencies");
  if (columns.size() > 2) field.frequencies_v = numbers_of(columns[2].view(), "frequencies");
  field.data.array = std::move(columns[0]);
  return field;
}

std::vector<FieldAnchor> anchors_of_file(const WaveSource& source, const std::string& path) {
  const std::vector<FieldStroke> strokes = source.strokes_of_file(path);
  try {
    return source.anchors(strokes, {});
  } catch (const Cancelled&) {
    throw;
  } catch (const Error& error) {
    throw Error(path + ": " + error.what());
  }
}

SmoothFieldOptions smooth_options(const WaveSource& source, const WaveOptions& options,
                                  const Progress& progress) {
  SmoothFieldOptions smooth;
  smooth.symmetry = symmetry_of(options);
  smooth.curvature_anchor = curvature_anchor(options);
  smooth.curvature_direction = options.curvature_direction;
  smooth.feature_anchor = options.feature_anchor;
  smooth.feature_angle_deg = options.feature_angle_deg;
  if (options.feature_radius) smooth.feature_radius = options.feature_radius->on(source.diagonal());
  if (options.normal_radius) smooth.normal_radius = options.normal_radius->on(source.diagonal());
  if (!options.strokes.empty()) smooth.anchors = anchors_of_file(source, options.strokes);
  if (!options.drawn_strokes.empty()) {
    const std::vector<FieldAnchor> drawn = source.anchors(options.drawn_strokes, progress);
    smooth.anchors.insert(smooth.anchors.end(), drawn.begin(), drawn.end());
  }
  return smooth;
}

Field smooth_field(const WaveSource& source, const WaveOptions& options, const LastDirections& last,
                   const Progress& progress) {
  Field field;
  if (last.same_surface) {
    field.directions = last.directions;
  } else {
    SmoothFieldOptions smooth = smooth_options(source, options, progress.part(0, 0.2));
    smooth.last.directions = last.directions;
    field.directions = source.smooth_field(smooth, progress.part(0.2, 1));
  }
  if (!last.directions.empty()) {
    field.step = field_step(field.directions, last.directions, symmetry_of(options));
  }
  return field;
}

Field make_field(const WaveSource& source, const WaveOptions& options, const LastDirections& last,
                 const Progress& progress) {
  if (options.direction) {
    return {{projected_direction_field(*options.direction, source.surface().normals()), {}, {}}};
  }
  if (is_smooth(options)) return smooth_field(source, options, last, progress);
  if (options.field == "raw-curvature") {
    return {{source.curvature_field(options.curvature_direction, progress), {}, {}}};
  }
  if (!is_array(options.field)) return file_field(source, options);
  ArraySource::PerVertex found = source.array(parse_array("--field", options.field));
  Field field = array_field(source, found.array, options);
  field.rows_nonfinite = found.rows_nonfinite;  // before rows were moved to vertices
  // Eigenvectors of the mean of tensors are better than means of eigenvectors.
  if (found.of_cells && !is_tensor(field.data.array))
    field.data = {std::move(*found.of_cells), true};
  return field;
}

/// Values that frequencies follow: an array, or a number per vertex.
DataArray frequency_values(const WaveSource& source, const ArrayOptions& options) {
  const std::string option = "--frequency-by", &value = options.frequency_by;
  if (is_array(value)) return source.array(parse_array(option, value)).array;
  const VertexValues values = source.values(option, value);
  return make_data_array(values.title, 1, values.values);
}

/// Frequencies of options override those of the field; empty if options have none.
std::optional<FrequencyField> chosen_frequencies(const WaveSource& source,
                                                 const WaveOptions& options, const Field& field) {
  const ArrayOptions& wanted = options.arrays;
  const float frequency = constant_frequency(source.diagonal(), options);
  if (!wanted.frequency.empty()) {
    const DataArray array = source.array(wanted.frequency).array;
    FrequencyField frequencies;
    source.check([&] { frequencies = frequencies_of(array, field.directions); });
    return frequencies;
  }
  if (!wanted.frequency_by.empty()) {
    return source.frequencies_by(frequency_values(source, wanted), frequency, wanted.range);
  }
  if (!field.frequencies.empty() && !says_one_frequency(options)) return std::nullopt;
  FrequencyField constant = constant_frequency_field(frequency, field.directions.size());
  keep_gaps(field.frequencies, constant);
  return constant;
}

/// Sets the frequencies of all waves, NaN if there is none. Throws CLI::ValidationError for
/// --frequency-smoothing with one frequency for all vertices.
void choose_frequencies(const WaveSource& source, const WaveOptions& options, Field& field) {
  const bool field_says = source.surface().any(!field.frequencies.empty());
  if (auto chosen = chosen_frequencies(source, options, field)) {
    field.frequencies = std::move(*chosen);
    field.frequencies_v.clear();
  }
  for (FrequencyField* frequencies : {&field.frequencies, &field.frequencies_v}) {
    for (float& frequency : *frequencies) frequency *= options.frequency_factor;
  }
  if (options.smoothing.frequency_periods == 0) return;
  if (!says_frequencies(options) && !field_says) refuse_frequency_smoothing();
}

/// Sets those of crossing stripes from options, which are uniform.
void choose_crossing_frequencies(const WaveSource& source, const WaveOptions& options,
                                 std::size_t vertices, FrequencyField& frequencies_v) {
  const auto everywhere = [&](float frequency) {
    return constant_frequency_field(options.frequency_factor * frequency, vertices);
  };
  if (options.frequency_v) frequencies_v = everywhere(*options.frequency_v);
  if (options.stripes_v) {
    frequencies_v = everywhere(frequency_of_stripes(*options.stripes_v, source.diagonal()));
  }
}

/// Weights of data per vertex or, for some, per triangle.
FieldWeight field_weight(const WaveSource& source, const std::string& weight, bool of_triangles) {
  if (is_own_weight(weight)) return {weight, {}};
  if (of_triangles && is_array(weight)) {
    const ArraySource::PerVertex found = source.array(parse_array(kWeightOption, weight));
    if (found.of_cells && found.of_cells->components == 1) {
      return {"", numbers_of(found.of_cells->view(), kWeightOption)};
    }
  }
  std::vector<float> values = source.values(kWeightOption, weight).values;
  return {"", of_triangles ? corner_means(source.mesh(), values) : std::move(values)};
}

}  // namespace

BaseField make_base_field(const WaveSource& source, const WaveOptions& options,
                          const LastDirections& last, const Progress& progress) {
  BaseField field = make_field(source, options, last, progress);
  field.notes = source.notes() + field.notes;
  if (is_measured(options)) {
    const FieldWeight weight =
        field_weight(source, options.smoothing.weight, field.data.of_triangles);
    source.check([&] {
      refuse_usage([&] { field.measured = measured_field(field.data, field.directions, weight); });
    });
    field.last = last.directions;
  }
  return field;
}

WaveRequest wave_request(const WaveOptions& options) {
  return {turn_deg(options), smoothing_options(options.smoothing, symmetry_of(options)),
          frequency_smoothing_options(options.smoothing)};
}

WavesOfField make_waves(const WaveSource& source, const WaveOptions& options, BaseField field,
                        const Progress& progress) {
  field.missing.too_far = source.drop_too_far(field.directions);
  choose_frequencies(source, options, field);
  WaveInput found{std::move(field.directions), std::move(field.frequencies),
                  std::move(field.frequencies_v)};
  found.may_have_gaps = field.may_have_gaps || says_frequencies(options);
  found.is_near = [&](Index v) { return source.is_near(v); };
  found.measured = std::move(field.measured);
  found.last = std::move(field.last);
  found.missing = field.missing;
  WavesOfField made;
  static_cast<WaveResult&>(made) =
      waves_of(source.surface(), wave_request(options), std::move(found), progress);
  choose_crossing_frequencies(source, options, made.waves.positions.size(), made.frequencies_v);
  made.field_rows_nonfinite = field.rows_nonfinite;
  made.notes = field.notes;
  made.field_step = field.step;
  return made;
}

}  // namespace brindle::tool
