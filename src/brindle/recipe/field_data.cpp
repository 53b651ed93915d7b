#include "brindle/recipe/field_data.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include <Eigen/Geometry>

#include "brindle/base/array_numbers.h"
#include "brindle/recipe/refusals.h"
#include "brindle/tensor_field.h"

namespace brindle {
namespace {

constexpr const char* kWeightOption = "--field-weight";

/// Calls `body` with every row of vectors of two or three numbers.
template <class Body>
void for_vectors(const DataArray& array, const Body& body) {
  const std::vector<double> numbers = doubles_of(array.view());
  const auto columns = static_cast<std::size_t>(array.components);
  for (std::size_t row = 0; row + columns <= numbers.size(); row += columns) {
    body(Eigen::Vector3d(numbers[row], numbers[row + 1], columns > 2 ? numbers[row + 2] : 0));
  }
}

std::vector<float> lengths_of(const DataArray& vectors) {
  std::vector<float> lengths;
  for_vectors(vectors, [&](const Eigen::Vector3d& vector) {
    lengths.push_back(static_cast<float>(vector.stableNorm()));
  });
  return lengths;
}

std::vector<float> weights_of(const FieldData& data, const FieldWeight& weight) {
  if (!weight.values.empty()) return weight.values;
  const bool tensor = data.array.rows() > 0 && is_tensor(data.array);
  if (weight.word == "length") {
    if (!tensor && data.array.rows() > 0) return lengths_of(data.array);
    throw RefusedOption(kWeightOption, "the field has no vectors whose length could count");
  }
  if (tensor) return tensor_anisotropy(data.array);
  if (weight.word.empty()) return {};
  throw RefusedOption(kWeightOption, "the field is no tensor: it has no anisotropy");
}

}  // namespace

MeasuredField measured_field(const FieldData& data, const DirectionField& directions,
                             const FieldWeight& weight) {
  MeasuredField measured;
  measured.of_triangles = data.of_triangles;
  if (data.of_triangles) {
    for_vectors(data.array, [&](const Eigen::Vector3d& vector) {
      measured.directions.push_back(vector.stableNormalized().cast<float>());
    });
  } else {
    measured.directions = directions;
  }
  measured.confidence = weights_of(data, weight);
  for (float& confidence : measured.confidence) {
    if (confidence < 0) throw RefusedOption(kWeightOption, "there are weights below zero");
    if (!std::isfinite(confidence)) confidence = 0;
  }
  return measured;
}

bool has_data(const MeasuredField& measured) {
  return std::ranges::any_of(measured.directions,
                             [](const Vec3& d) { return d.allFinite() && !d.isZero(0); });
}

std::vector<float> corner_means(const Mesh& mesh, const std::vector<float>& of_vertices) {
  std::vector<float> means;
  for (const auto& [a, b, c] : mesh.triangles) {
    means.push_back((of_vertices[a] + of_vertices[b] + of_vertices[c]) / 3);
  }
  return means;
}

}  // namespace brindle
