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

DataArrays fitted(const std::filesystem::path& path, DataArrays own, const DataArrays& input,
                  JobListener& listener) {
  std::vector<std::string> notes;
  FittedArrays result = fitted_arrays(path, join_arrays(std::move(own), input, notes));
  note(notes, listener);
  note(result.left_out, listener);
  return std::move(result.arrays);
}

DataArrays held_beside(std::span<const std::string> own, const std::filesystem::path& path,
                       const DataArrays& arrays, JobListener& listener) {
  DataArrays held;
  const bool replaced = hold_pattern(arrays.points);
  const auto add = [&](std::vector<DataArray>& to, const std::vector<DataArray>& from) {
    for (auto& [array, renamed] : arrays_beside(own, from, replaced)) {
      if (find_array(held.points, array.name) != nullptr) continue;
      const std::vector<std::string> why = fitted_arrays(path, {{array}, {}}).left_out;
      note(why, listener);
      if (!why.empty()) continue;
      if (!renamed.empty()) note({renamed}, listener);
      to.push_back(std::move(array));
    }
  };
  add(held.points, arrays.points);
  add(held.cells, arrays.cells);
  return held;
}

}  // namespace brindle::tool
