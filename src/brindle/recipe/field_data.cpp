#include "brindle/recipe/field_data.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

#include <Eigen/Geometry>

#include "brindle/base/array_numbers.h"
#include "brindle/base/array_rows.h"
#include "brindle/base/standard.h"
#include "brindle/base/text.h"
#include "brindle/error.h"
#include "brindle/recipe/refusals.h"
#include "brindle/tensor_field.h"

namespace brindle {
namespace {

constexpr const char* kWeightOption = "--field-weight";

/// Calls `body` with every row of vectors of two or three numbers.
template <class Body>
void for_vectors(const DataArray& array, const Body& body) {
  const std::vector<double> numbers = doubles_of(array.axes());
  const auto columns = static_cast<std::size_t>(array.components);
  for (std::size_t row = 0; row + columns <= numbers.size(); row += columns) {
    body(Eigen::Vector3d(numbers[row], numbers[row + 1], columns > 2 ? numbers[row + 2] : 0));
  }
}

/// Scales weights to a maximum of 1 where float sums of them would vanish or overflow; their unit
/// does not matter.
template <class Number>
std::vector<float> as_weights(const std::vector<Number>& numbers) {
  constexpr double kTiny = 1e-30, kHuge = 1e30;
  double largest = 0;
  for (const double number : numbers) {
    if (number < 0) {
      throw Error(kWeightOption + formatted(": there are weights below zero, such as %g", number) +
                  "; give 0 or above, or nan for no datum");
    }
    if (std::isfinite(number)) largest = std::max(largest, number);
  }
  const bool fits = largest == 0 || (largest > kTiny && largest < kHuge);
  std::vector<float> weights;
  weights.reserve(numbers.size());
  for (const double number : numbers) {
    weights.push_back(static_cast<float>(fits ? number : number / largest));
  }
  return weights;
}

std::vector<float> lengths_of(const DataArray& vectors) {
  std::vector<double> lengths;
  for_vectors(vectors,
              [&](const Eigen::Vector3d& vector) { lengths.push_back(vector.stableNorm()); });
  return as_weights(lengths);
}

std::vector<float> weights_of(const FieldData& data, const FieldWeight& weight) {
  if (!weight.values.empty()) return as_weights(weight.values);
  const bool tensor = data.array.rows() > 0 && is_tensor(data.array);
  if (weight.word == "length") {
    if (!tensor && data.array.rows() > 0) return lengths_of(data.array);
    throw RefusedOption(kWeightOption, "the field has no vectors whose length could count");
  }
  if (tensor) return tensor_anisotropy(data.array);
  if (weight.word.empty()) return {};
  throw RefusedOption(kWeightOption, "the field is no tensor: it has no anisotropy");
}

Eigen::Vector3d place_of(const Mesh& mesh, std::size_t vertex) {
  return mesh.origin + mesh.positions[vertex].cast<double>();
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
    if (!std::isfinite(confidence)) confidence = 0;
  }
  return measured;
}

bool has_data(const MeasuredField& measured) {
  return ranges::any_of(measured.directions,
                        [](const Vec3& d) { return d.allFinite() && !d.isZero(0); });
}

DataArray globe_vectors(const Mesh& mesh, const DataArray& east_north) {
  return globe_vectors(mesh, east_north, globe_radii(mesh));
}

GlobeRadii globe_radii(const Mesh& mesh) {
  GlobeRadii radii;
  for (std::size_t v = 0; v < mesh.vertex_count(); ++v) {
    radii.nearest = std::min(radii.nearest, place_of(mesh, v).norm());
    radii.farthest = std::max(radii.farthest, place_of(mesh, v).norm());
  }
  return radii;
}

DataArray globe_vectors(const Mesh& mesh, const DataArray& east_north, const GlobeRadii& of_whole) {
  check_rows_per_vertex(east_north, mesh.vertex_count());
  if (east_north.components != 2) {
    throw Error("array '" + east_north.name + "' has " + std::to_string(east_north.components) +
                " numbers in a row; vectors on a globe have 2, towards the east and the north");
  }
  if (!(of_whole.farthest < 2 * of_whole.nearest)) {
    throw Error(
        "the columns 'east' and 'north' are of a globe around 0,0,0, or a part of one, and "
        "the mesh is neither; give vectors of x, y and z, or move the mesh");
  }
  const std::vector<double> numbers = doubles_of(east_north.view());
  std::vector<double> vectors;
  for (std::size_t v = 0; v < mesh.vertex_count(); ++v) {
    const Eigen::Vector3d up = place_of(mesh, v).normalized();
    const Eigen::Vector3d east = Eigen::Vector3d(-up.y(), up.x(), 0).normalized();
    const Eigen::Vector3d vector = numbers[2 * v] * east + numbers[2 * v + 1] * up.cross(east);
    const bool is_pole = up.head<2>().norm() < 1e-6;
    for (const double number : vector) {
      vectors.push_back(is_pole ? std::numeric_limits<double>::quiet_NaN() : number);
    }
  }
  return make_data_array(east_north.name, 3, vectors);
}

void keep_gaps(const FrequencyField& of_file, FrequencyField& frequencies) {
  for (std::size_t v = 0; v < of_file.size(); ++v) {
    if (!std::isfinite(of_file[v])) frequencies[v] = of_file[v];
  }
}

std::vector<float> corner_means(const Mesh& mesh, const std::vector<float>& of_vertices) {
  std::vector<float> means;
  for (const auto& [a, b, c] : mesh.triangles) {
    means.push_back((of_vertices[a] + of_vertices[b] + of_vertices[c]) / 3);
  }
  return means;
}

namespace {

const char* const kPoints = "points/";
const char* const kCells = "cells/";

ArrayChoice find_choice(const DataArrays& arrays, std::string_view name) {
  if (const DataArray* array = find_array(arrays.points, name)) return {array, false};
  if (const DataArray* array = find_array(arrays.cells, name)) return {array, true};
  if (name.starts_with(kPoints)) {
    return {find_array(arrays.points, name.substr(std::string_view(kPoints).size())), false};
  }
  if (name.starts_with(kCells)) {
    return {find_array(arrays.cells, name.substr(std::string_view(kCells).size())), true};
  }
  return {};
}

[[noreturn]] void refuse_name(const DataArrays& arrays, const std::string& name,
                              const std::string& file) {
  if (arrays.points.empty() && arrays.cells.empty()) {
    throw Error(shown(file) + ": no array '" + name +
                "': it has no arrays that belong to vertices "
                "or triangles");
  }
  std::vector<std::string> known;
  for (const auto* list : {&arrays.points, &arrays.cells}) {
    for (const DataArray& array : *list) known.push_back(array.name);
  }
  const std::string meant = nearest(name, known);
  std::string text = shown(file) + ": no array '" + name + "'";
  if (!meant.empty()) text += "; did you mean '" + printable(meant) + "'?";
  text += meant.empty() ? "; there are" : " There are";
  if (!arrays.points.empty()) text += " per point: " + list_of(arrays.points);
  if (!arrays.points.empty() && !arrays.cells.empty()) text += "; and";
  if (!arrays.cells.empty()) text += " per cell: " + list_of(arrays.cells);
  throw Error(text);
}

}  // namespace

std::string list_of(std::span<const DataArray> arrays) {
  std::string text;
  for (const DataArray& array : arrays) {
    if (!text.empty()) text += ", ";
    text += printable(array.name);
    if (array.components > 1) text += " (" + std::to_string(array.components) + ")";
  }
  return text;
}

ArrayChoice choice_of(const DataArrays& arrays, const std::string& name, const std::string& file) {
  const ArrayChoice choice = find_choice(arrays, name);
  if (choice.array == nullptr) refuse_name(arrays, name, file);
  return choice;
}

DataArrays named_arrays(const DataArrays& arrays, std::span<const std::string> names,
                        const std::string& file) {
  DataArrays named;
  for (const std::string& name : names) {
    const auto [array, of_cells] = choice_of(arrays, name, file);
    std::vector<DataArray>& list = of_cells ? named.cells : named.points;
    if (find_array(list, array->name) == nullptr) list.push_back(*array);
  }
  return named;
}

DataArray array_named(const DataArrays& arrays, const std::string& name, const std::string& file) {
  return *choice_of(arrays, name, file).array;
}

}  // namespace brindle
