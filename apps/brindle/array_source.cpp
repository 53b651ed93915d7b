#include "array_source.h"

#include <algorithm>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include "brindle/base/printable.h"
#include "brindle/base/suggestion.h"
#include "brindle/error.h"
#include "brindle/files.h"
#include "brindle/mesh_data.h"
#include "brindle/nearby_data.h"
#include "surface_options.h"

namespace brindle::tool {
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

namespace {

[[noreturn]] void refuse_name(const DataArrays& arrays, const std::string& name,
                              const std::string& file) {
  if (arrays.points.empty() && arrays.cells.empty()) {
    throw Error(file + ": no array '" + name +
                "': the file has no arrays that belong to vertices "
                "or triangles");
  }
  std::vector<std::string> known;
  for (const auto* list : {&arrays.points, &arrays.cells}) {
    for (const DataArray& array : *list) known.push_back(array.name);
  }
  const std::string meant = nearest(name, known);
  std::string text = file + ": no array '" + name + "'";
  if (!meant.empty()) text += "; did you mean '" + printable(meant) + "'?";
  text += meant.empty() ? "; there are" : " There are";
  if (!arrays.points.empty()) text += " per point: " + list_of(arrays.points);
  if (!arrays.points.empty() && !arrays.cells.empty()) text += "; and";
  if (!arrays.cells.empty()) text += " per cell: " + list_of(arrays.cells);
  throw Error(text);
}

/// Every line with the name of the file before it.
std::string lines_about(const std::string& file, const std::string& text) {
  std::string lines;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find('\n', begin), text.size() - 1) + 1;
    lines += file + ": " + text.substr(begin, end - begin);
    begin = end;
  }
  return lines;
}

}  // namespace

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

/// The mesh of another file, with its arrays.
struct OtherMesh {
  std::string file;
  Mesh mesh;
  DataArrays arrays;
  std::string notes;
  NearbyRows rows;  // one per vertex of the surface
};

namespace {

OtherMesh read_other(const std::string& file) {
  OtherMesh other;
  other.file = file;
  if (is_point_file(file)) {
    LoadedPoints loaded = read_points(file);
    other.notes = describe(loaded);
    for (const Index i : loaded.cloud.used) {
      other.mesh.positions.push_back(loaded.cloud.positions[i]);
    }
    other.mesh.origin = loaded.cloud.origin;
    other.arrays.points = rows_of(loaded.arrays, loaded.cloud.used);
  } else {
    LoadedMesh loaded = read_mesh(file);
    other.notes = describe(loaded);
    other.mesh = std::move(loaded.mesh);
    other.arrays = std::move(loaded.arrays);
  }
  other.notes = lines_about(file, other.notes);
  return other;
}

}  // namespace

ArraySource::ArraySource(const Surface& surface, const DataArrays& arrays, std::string file,
                         const ArrayOptions& options)
    : surface_(surface), own_(arrays), file_(std::move(file)) {
  if (options.mesh.empty()) return;
  other_ = std::make_unique<OtherMesh>(read_other(options.mesh));
  const Length limit = options.max_distance.value_or(kDefaultMaxDistance);
  const float distance = limit.on(bounding_box(surface.mesh).diagonal());
  other_->rows = nearby_rows(other_->mesh, surface.mesh, static_cast<double>(distance));
}

ArraySource::~ArraySource() = default;

ArraySource::PerVertex ArraySource::array(const std::string& name) const {
  const DataArrays& arrays = other_ ? other_->arrays : own_;
  const auto [array, of_cells] = choice_of(arrays, name, other_ ? other_->file : file_);
  const std::size_t nonfinite = nonfinite_rows(*array);
  if (other_) {
    return {of_cells ? carried_from_cells(*array, other_->rows)
                     : carried_from_points(*array, other_->rows),
            nonfinite};
  }
  return {of_cells ? cells_to_points(surface_.mesh, *array) : *array, nonfinite};
}

std::optional<std::size_t> ArraySource::drop_too_far(DirectionField& directions) const {
  if (!other_) return std::nullopt;
  std::size_t count = 0;
  for (Index v = 0; v < directions.size(); ++v) {
    if (is_near(v)) continue;
    directions[v] = Vec3::Zero();
    count += surface_.neighborhood->of(v).empty() ? 0 : 1;
  }
  return count;
}

bool ArraySource::is_near(Index vertex) const { return !other_ || other_->rows.found[vertex] != 0; }

std::string ArraySource::notes() const { return other_ ? other_->notes : ""; }

}  // namespace brindle::tool
