#include "input/wave_source.h"

#include <utility>

#include "brindle/direction_field.h"
#include "brindle/files.h"
#include "brindle/normals.h"
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

}  // namespace brindle::tool
