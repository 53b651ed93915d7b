#include "input/make_waves.h"

#include <algorithm>
#include <utility>

#include "brindle/array_field.h"
#include "brindle/direction_field.h"
#include "brindle/error.h"
#include "brindle/files.h"
#include "brindle/normals.h"
#include "brindle/recipe/field_data.h"
#include "brindle/smooth_field.h"
#include "brindle/strokes.h"
#include "brindle/tensor_field.h"
#include "cli/command_line.h"
#include "input/array_source.h"
#include "input/csv_field.h"
#include "input/vertex_values.h"

namespace brindle::tool {
namespace {

using Field = BaseField;

Field rows_field(const Surface& surface, const std::string& path,
                 std::span<const Index> vertex_of_row) {
  FieldFile file = read_rows(surface, path, vertex_of_row);
  const auto nonfinite = std::count_if(file.vectors.begin(), file.vectors.end(),
                                       [](const Vec3& vector) { return !vector.allFinite(); });
  Field field;
  field.directions = tangent_directions(file.vectors, surface.normals);
  field.frequencies = std::move(file.frequencies);
  field.frequencies_v = std::move(file.frequencies_v);
  field.rows_nonfinite = static_cast<std::size_t>(nonfinite);
  field.data.array = make_data_array("vector", file.vectors);
  return field;
}

Field tensor_field(const Surface& surface, const DataArray& array, const ArrayOptions& options) {
  TensorField tensor = tensor_field_of(surface, array, options.tensor.value_or(TensorAxis::major));
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

Field array_field(const Surface& surface, const DataArray& given, const WaveOptions& options) {
  const DataArray array = ordered_array(given, options.arrays);
  Field field;
  if (is_tensor(array)) {
    field = tensor_field(surface, array, options.arrays);
  } else if (options.arrays.tensor) {
    refuse_tensor("the array '" + array.name + "' has " + std::to_string(array.components) +
                  " numbers in a row, and is no tensor");
  } else {
    field.directions = direction_field_of(surface, array, has_signs(options));
  }
  field.rows_nonfinite = nonfinite_rows(array);
  field.data.array = array;
  return field;
}

Field file_field(const Surface& surface, const WaveOptions& options, const FileData& data) {
  const CsvFieldName name = csv_field_name(options.field);
  if (const std::optional<CsvField> csv = read_csv_field(name)) {
    const DataArray rows = with_copies(surface, csv->array);
    const DataArray array = csv->of_globe ? globe_vectors(surface.mesh, rows) : rows;
    Field field = array_field(surface, array, options);
    if (!csv->frequency) return field;
    field.frequencies = frequencies_of(with_copies(surface, *csv->frequency), field.directions);
    field.may_have_gaps = true;
    return field;
  }
  if (options.arrays.tensor) refuse_tensor("the field '" + name.path + "' has vectors alone");
  return rows_field(surface, name.path, data.vertex_of_row);
}

void add_read_strokes(const Surface& surface, const std::string& path,
                      std::vector<FieldAnchor>& anchors) {
  const std::vector<FieldStroke> strokes = read_strokes(path);
  try {
    anchors = stroke_anchors(surface, strokes);
  } catch (const Error& error) {
    throw Error(path + ": " + error.what());
  }
}

SmoothFieldOptions smooth_options(const Surface& surface, const WaveOptions& options,
                                  const Progress& progress) {
  SmoothFieldOptions smooth;
  smooth.symmetry = symmetry_of(options);
  smooth.curvature_anchor = curvature_anchor(options);
  smooth.curvature_direction = options.curvature_direction;
  smooth.feature_anchor = options.feature_anchor;
  smooth.feature_angle_deg = options.feature_angle_deg;
  if (options.feature_radius) {
    smooth.feature_radius = options.feature_radius->on(bounding_box(surface.mesh).diagonal());
  }
  if (options.normal_radius) {
    smooth.normal_radius = options.normal_radius->on(bounding_box(surface.mesh).diagonal());
  }
  if (!options.strokes.empty()) add_read_strokes(surface, options.strokes, smooth.anchors);
  if (!options.drawn_strokes.empty()) {
    const std::vector<FieldAnchor> drawn = stroke_anchors(surface, options.drawn_strokes, progress);
    smooth.anchors.insert(smooth.anchors.end(), drawn.begin(), drawn.end());
  }
  return smooth;
}

Field smooth_field(const Surface& surface, const WaveOptions& options, const LastDirections& last,
                   const Progress& progress) {
  Field field;
  if (last.same_surface) {
    field.directions = last.directions;
  } else {
    SmoothFieldOptions smooth = smooth_options(surface, options, progress.part(0, 0.2));
    smooth.last.directions = last.directions;
    field.directions = smooth_direction_field(surface, smooth, progress.part(0.2, 1));
  }
  if (!last.directions.empty()) {
    field.step = field_step(field.directions, last.directions, symmetry_of(options));
  }
  return field;
}

Field make_field(const Surface& surface, const WaveOptions& options, const FileData& data,
                 const ArraySource& arrays, const LastDirections& last, const Progress& progress) {
  if (options.direction)
    return {{projected_direction_field(*options.direction, surface.normals), {}, {}}};
  if (is_smooth(options)) return smooth_field(surface, options, last, progress);
  if (options.field == "raw-curvature") {
    const auto curvatures = principal_curvatures(surface.mesh.positions, surface.normals,
                                                 *surface.neighborhood, progress.part(0, 0.6));
    DirectionField directions = curvature_direction_field(curvatures, options.curvature_direction);
    // Solvers are faster if few adjacent directions are opposite.
    orient_alike(*surface.neighborhood, directions, progress.part(0.6, 1));
    return {{std::move(directions), {}, {}}};
  }
  if (!is_array(options.field)) return file_field(surface, options, data);
  ArraySource::PerVertex found = arrays.array(parse_array("--field", options.field));
  Field field = array_field(surface, found.array, options);
  field.rows_nonfinite = found.rows_nonfinite;  // before rows were moved to vertices
  // Eigenvectors of the mean of tensors are better than means of eigenvectors.
  if (found.of_cells && !is_tensor(field.data.array))
    field.data = {std::move(*found.of_cells), true};
  return field;
}

/// Values that frequencies follow: an array, or a number per vertex.
DataArray frequency_values(const Surface& surface, const ArrayOptions& options,
                           const FileData& data, const ArraySource& arrays) {
  const std::string option = "--frequency-by", &value = options.frequency_by;
  if (is_array(value)) return arrays.array(parse_array(option, value)).array;
  const ValueSource source{surface, data.arrays,        data.name,
                           options, data.vertex_of_row, data.viewpoint};
  const VertexValues values = vertex_values(option, value, source);
  return make_data_array(values.title, 1, values.values);
}

/// Frequencies of options override those of the field; empty if options have none.
std::optional<FrequencyField> chosen_frequencies(const Surface& surface, const WaveOptions& options,
                                                 const FileData& data, const ArraySource& arrays,
                                                 const Field& field) {
  const ArrayOptions& wanted = options.arrays;
  if (!wanted.frequency.empty()) {
    return frequencies_of(arrays.array(wanted.frequency).array, field.directions);
  }
  if (!wanted.frequency_by.empty()) {
    return frequencies_by(surface, frequency_values(surface, wanted, data, arrays),
                          constant_frequency(surface.mesh, options), wanted.range);
  }
  if (!field.frequencies.empty() && !says_one_frequency(options)) return std::nullopt;
  FrequencyField constant = constant_frequency_field(constant_frequency(surface.mesh, options),
                                                     surface.mesh.vertex_count());
  keep_gaps(field.frequencies, constant);
  return constant;
}

/// Sets the frequencies of all waves, NaN if there is none. Throws CLI::ValidationError for
/// --frequency-smoothing with one frequency for all vertices.
void choose_frequencies(const Surface& surface, const WaveOptions& options, const FileData& data,
                        Field& field) {
  const bool field_says = !field.frequencies.empty();
  if (auto chosen = chosen_frequencies(surface, options, data, *field.arrays, field)) {
    field.frequencies = std::move(*chosen);
    field.frequencies_v.clear();
  }
  for (FrequencyField* frequencies : {&field.frequencies, &field.frequencies_v}) {
    for (float& frequency : *frequencies) frequency *= options.frequency_factor;
  }
  if (options.detail.frequency_periods == 0) return;
  if (!says_frequencies(options) && !field_says) refuse_frequency_smoothing();
}

/// Sets those of crossing stripes from options, which are uniform.
void choose_crossing_frequencies(const Surface& surface, const WaveOptions& options,
                                 FrequencyField& frequencies_v) {
  const auto everywhere = [&](float frequency) {
    return constant_frequency_field(options.frequency_factor * frequency,
                                    surface.mesh.vertex_count());
  };
  if (options.frequency_v) frequencies_v = everywhere(*options.frequency_v);
  if (options.stripes_v) {
    frequencies_v =
        everywhere(frequency_of_stripes(*options.stripes_v, bounding_box(surface.mesh).diagonal()));
  }
}

}  // namespace

BaseField make_base_field(const Surface& surface, const WaveOptions& options, const FileData& data,
                          const LastDirections& last, const Progress& progress) {
  auto arrays =
      std::make_shared<const ArraySource>(surface, data.arrays, data.name, options.arrays);
  BaseField field = make_field(surface, options, data, *arrays, last, progress);
  field.notes = arrays->notes() + field.notes;
  if (is_measured(options)) {
    const ValueSource source{surface, data.arrays, data.name, options.arrays, data.vertex_of_row};
    refuse_usage([&] {
      field.measured =
          measured_field(field.data, field.directions,
                         field_weight(source, *arrays, options.detail, field.data.of_triangles));
    });
    field.last = last.directions;
  }
  field.arrays = std::move(arrays);
  return field;
}

WaveRequest wave_request(const WaveOptions& options) {
  return {turn_deg(options), detail_options(options.detail, symmetry_of(options)),
          frequency_smoothing_options(options.detail)};
}

WavesOfField make_waves(const Surface& surface, const WaveOptions& options, const FileData& data) {
  return make_waves(surface, options, data, make_base_field(surface, options, data));
}

WavesOfField make_waves(const Surface& surface, const WaveOptions& options, const FileData& data,
                        BaseField field, const Progress& progress) {
  const ArraySource& arrays = *field.arrays;
  field.missing.too_far = arrays.drop_too_far(field.directions);
  choose_frequencies(surface, options, data, field);
  WaveInput found{std::move(field.directions), std::move(field.frequencies),
                  std::move(field.frequencies_v)};
  found.may_have_gaps = field.may_have_gaps || says_frequencies(options);
  found.is_near = [&](Index v) { return arrays.is_near(v); };
  found.measured = std::move(field.measured);
  found.last = std::move(field.last);
  found.missing = field.missing;
  WavesOfField made;
  static_cast<WaveResult&>(made) =
      waves_of(WholeSurface(surface), wave_request(options), std::move(found), progress);
  choose_crossing_frequencies(surface, options, made.frequencies_v);
  made.field_rows_nonfinite = field.rows_nonfinite;
  made.notes = field.notes;
  made.field_step = field.step;
  return made;
}

}  // namespace brindle::tool
