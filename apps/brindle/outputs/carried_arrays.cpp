#include "outputs/carried_arrays.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "brindle/files.h"

namespace brindle::tool {
namespace {

std::vector<std::string> names_of(std::span<const DataArray> arrays) {
  std::vector<std::string> names;
  for (const DataArray& array : arrays) names.push_back(array.name);
  return names;
}

}  // namespace

std::vector<DataArray> without(std::span<const DataArray> arrays,
                               std::span<const std::string> names) {
  std::vector<DataArray> result;
  std::copy_if(arrays.begin(), arrays.end(), std::back_inserter(result),
               [&](const DataArray& array) {
                 return std::find(names.begin(), names.end(), array.name) == names.end();
               });
  return result;
}

DataArrays joined(DataArrays own, const DataArrays& input) {
  const auto add = [](std::vector<DataArray>& to, const std::vector<DataArray>& from) {
    for (DataArray& array : without(from, names_of(to))) to.push_back(std::move(array));
  };
  add(own.points, input.points);
  add(own.cells, input.cells);
  return own;
}

DataArrays held_beside(std::span<const std::string> own, const std::filesystem::path& path,
                       const DataArrays& arrays, JobListener& listener) {
  DataArrays held;
  const auto add = [&](std::vector<DataArray>& to, const std::vector<DataArray>& from) {
    for (DataArray& array : without(from, own)) {
      if (find_array(held.points, array.name) != nullptr) continue;
      const std::vector<std::string> why = fitted_arrays(path, {{array}, {}}).left_out;
      for (const std::string& line : why) listener.note(line + "\n");
      if (why.empty()) to.push_back(std::move(array));
    }
  };
  add(held.points, arrays.points);
  add(held.cells, arrays.cells);
  return held;
}

std::vector<DataArray> arrays_at(std::span<const TrianglePoint> places,
                                 std::span<const Triangle> triangles, const DataArrays& arrays) {
  std::vector<RowBlend> blends;
  std::vector<Index> rows;
  for (const TrianglePoint& place : places) {
    blends.push_back({triangles[place.triangle], place.barycentric});
    rows.push_back(place.triangle);
  }
  std::vector<DataArray> result = blended(arrays.points, blends);
  for (DataArray& array : rows_of(arrays.cells, rows)) result.push_back(std::move(array));
  return result;
}

}  // namespace brindle::tool
