#include "make_waves.h"

#include <algorithm>
#include <numbers>
#include <utility>

#include "array_source.h"
#include "brindle/array_field.h"
#include "brindle/curvature.h"
#include "brindle/files.h"
#include "brindle/smooth_field.h"
#include "brindle/tensor_field.h"
#include "brindle/waves/orientation.h"
#include "csv_field.h"

namespace brindle::tool {
namespace {

struct Field {
  DirectionField directions;
  FrequencyField frequencies;    // empty if the field says nothing of them
  FrequencyField frequencies_v;  // the same of crossing stripes
  std::optional<std::size_t> rows_nonfinite = {};
  MissingWaves missing = {};
  std::string notes = {};
};

Field rows_field(const Surface& surface, const std::string& path,
                 std::span<const Index> vertex_of_row) {
  FieldFile file = read_field_csv(path, surface.mesh.vertex_count(), vertex_of_row);
  const auto nonfinite = std::count_if(file.vectors.begin(), file.vectors.end(),
                                       [](const Vec3& vector) { return !vector.allFinite(); });
  return {tangent_directions(file.vectors, surface.normals), std::move(file.frequencies),
          std::move(file.frequencies_v), static_cast<std::size_t>(nonfinite)};
}

Field tensor_field(const Surface& surface, const DataArray& array, const ArrayOptions& options) {
  TensorField tensor = tensor_field_of(surface, array, options.tensor.value_or(TensorAxis::major));
  Field field{std::move(tensor.directions), {}, {}};
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

Field array_field(const Surface& surface, const DataArray& array, const ArrayOptions& options) {
  Field field;
  if (is_tensor(array)) {
    field = tensor_field(surface, array, options);
  } else if (options.tensor) {
    refuse_tensor("the array '" + array.name + "' has " + std::to_string(array.components) +
                  " numbers in a row, and is no tensor");
  } else {
    field.directions = direction_field_of(surface, array);
  }
  field.rows_nonfinite = nonfinite_rows(array);
  return field;
}

Field file_field(const Surface& surface, const WaveOptions& options, const FileData& data) {
  const CsvFieldName name = csv_field_name(options.field);
  if (const auto array = csv_field_array(name)) return array_field(surface, *array, options.arrays);
  if (options.arrays.tensor) refuse_tensor("the field '" + name.path + "' has vectors alone");
  return rows_field(surface, name.path, data.vertex_of_row);
}

Field make_field(const Surface& surface, const WaveOptions& options, const FileData& data,
                 const ArraySource& arrays) {
  if (options.direction)
    return {projected_direction_field(*options.direction, surface.normals), {}, {}};
  if (is_smooth(options)) {
    SmoothFieldOptions smooth;
    smooth.symmetry = options.cross ? 4 : 2;
    smooth.curvature_anchor = curvature_anchor(options);
    smooth.curvature_direction = options.curvature_direction;
    smooth.feature_anchor = options.feature_anchor;
    smooth.feature_angle_deg = options.feature_angle_deg;
    return {smooth_direction_field(surface, smooth), {}, {}};
  }
  if (options.field == "raw-curvature") {
    const auto curvatures =
        principal_curvatures(surface.mesh.positions, surface.normals, *surface.neighborhood);
    DirectionField directions = curvature_direction_field(curvatures, options.curvature_direction);
    // The solvers are faster where few neighbours run against each other.
    orient_alike(*surface.neighborhood, directions);
    return {std::move(directions), {}, {}};
  }
  if (!is_array(options.field)) return file_field(surface, options, data);
  const auto [array, rows_nonfinite] = arrays.array(parse_array("--field", options.field));
  Field field = array_field(surface, array, options.arrays);
  field.rows_nonfinite = rows_nonfinite;  // before rows were moved to vertices
  return field;
}

// What options say goes before what the field says.
void choose_frequencies(const Surface& surface, const WaveOptions& options,
                        const ArraySource& arrays, Field& field) {
  const ArrayOptions& wanted = options.arrays;
  if (wanted.frequency.empty() && wanted.frequency_by.empty()) {
    if (!field.frequencies.empty() && !options.stripes && !options.frequency) return;
    field.frequencies = constant_frequency_field(constant_frequency(surface.mesh, options),
                                                 surface.mesh.vertex_count());
  } else if (!wanted.frequency.empty()) {
    field.frequencies = frequencies_of(arrays.array(wanted.frequency).array, field.directions);
  } else {
    field.frequencies = frequencies_by(surface, arrays.array(wanted.frequency_by).array,
                                       constant_frequency(surface.mesh, options), wanted.range);
  }
  field.frequencies_v.clear();
}

// Waves of arrays that are not everywhere.
void drop_waves(const ArrayOptions& options, Field& field) {
  if (options.frequency.empty() && options.frequency_by.empty()) return;
  field.missing.without_frequency =
      drop_waves_without_frequency(field.directions, field.frequencies);
}

}  // namespace

WavesAndCrossing make_waves(const Surface& surface, const WaveOptions& options,
                            const FileData& data) {
  const ArraySource arrays(surface, data.arrays, data.name, options.arrays);
  Field field = make_field(surface, options, data, arrays);
  const float turn_deg = options.rotate_deg + (options.along ? 90.0f : 0.0f);
  if (turn_deg != 0) {
    field.directions =
        rotated(field.directions, surface.normals, turn_deg * std::numbers::pi_v<float> / 180);
  }
  field.missing.too_far = arrays.drop_too_far(field.directions);
  choose_frequencies(surface, options, arrays, field);
  drop_waves(options.arrays, field);
  const auto everywhere = [&](float frequency) {
    return constant_frequency_field(frequency, surface.mesh.vertex_count());
  };
  if (options.frequency_v) field.frequencies_v = everywhere(*options.frequency_v);
  if (options.stripes_v) {
    field.frequencies_v =
        everywhere(frequency_of_stripes(*options.stripes_v, bounding_box(surface.mesh).diagonal()));
  }
  return {{surface.mesh.positions, std::move(field.directions), std::move(field.frequencies)},
          std::move(field.frequencies_v),
          field.rows_nonfinite,
          field.missing,
          arrays.notes() + field.notes};
}

}  // namespace brindle::tool
