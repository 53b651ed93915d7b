#include "outputs/carried_arrays.h"

#include <utility>

#include "brindle/files.h"
#include "brindle/pattern_arrays.h"

namespace brindle::tool {
namespace {

void note(const std::vector<std::string>& sentences, JobListener& listener) {
  for (const std::string& sentence : sentences) listener.note(sentence + "\n");
}

}  // namespace

DataArrays joined(DataArrays own, const DataArrays& input, JobListener& listener) {
  std::vector<std::string> notes;
  DataArrays arrays = join_arrays(std::move(own), input, notes);
  note(notes, listener);
  return arrays;
}

DataArrays held_beside(std::span<const std::string> own, const std::filesystem::path& path,
                       const DataArrays& arrays, JobListener& listener) {
  DataArrays held;
  std::vector<std::string> notes;
  const bool replaced = hold_pattern(arrays.points);
  const auto add = [&](std::vector<DataArray>& to, const std::vector<DataArray>& from) {
    for (DataArray& array : arrays_beside(own, from, replaced, notes)) {
      if (find_array(held.points, array.name) != nullptr) continue;
      const std::vector<std::string> why = fitted_arrays(path, {{array}, {}}).left_out;
      note(why, listener);
      if (why.empty()) to.push_back(std::move(array));
    }
  };
  add(held.points, arrays.points);
  add(held.cells, arrays.cells);
  note(notes, listener);
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
