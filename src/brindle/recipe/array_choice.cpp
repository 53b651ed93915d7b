#include "brindle/recipe/array_choice.h"

#include <string_view>
#include <vector>

#include "brindle/base/text.h"
#include "brindle/error.h"

namespace brindle {
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
