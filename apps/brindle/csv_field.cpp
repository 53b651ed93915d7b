#include "csv_field.h"

#include <algorithm>
#include <filesystem>
#include <utility>
#include <vector>

#include "array_source.h"
#include "brindle/error.h"
#include "brindle/files.h"
#include "brindle/files/component_groups.h"
#include "brindle/files/csv_file.h"

namespace brindle::tool {
namespace {

/// What the columns of a file would make, without rows.
std::vector<DataArray> arrays_named_in(const std::string& path) {
  const CsvFile file(path, {"field", "x,y,z or x,y,z,frequency"});
  std::vector<DataArray> columns;
  for (const std::string& name : file.names()) {
    columns.push_back({name, NumberType::float64, 1, {}});
  }
  return grouped_columns(std::move(columns));
}

/// ParaView writes positions and normals with all that it writes.
bool is_data_vector(const DataArray& array) {
  return array.components == 3 && array.name != "Points" && array.name != "Normals";
}

bool has_vector_first(const std::vector<DataArray>& arrays) {
  return !arrays.empty() && arrays[0].components == 3 && arrays.size() <= 3 &&
         std::all_of(arrays.begin() + 1, arrays.end(),
                     [](const DataArray& array) { return array.components == 1; });
}

}  // namespace

CsvFieldName csv_field_name(const std::string& field) {
  std::error_code ignored;
  const std::size_t colon = field.rfind(".csv:");
  if (colon == std::string::npos || std::filesystem::exists(field, ignored)) return {field, ""};
  return {field.substr(0, colon + 4), field.substr(colon + 5)};
}

std::optional<DataArray> csv_field_array(const CsvFieldName& name) {
  if (!name.array.empty()) {
    DataArrays arrays{read_csv_arrays(name.path), {}};
    return array_named(arrays, name.array, name.path);
  }
  std::error_code ignored;
  if (!std::filesystem::is_regular_file(name.path, ignored))
    return std::nullopt;  // read once alone
  const std::vector<DataArray> arrays = arrays_named_in(name.path);
  const auto vector = std::find_if(arrays.begin(), arrays.end(), is_data_vector);
  if (vector == arrays.end() || has_vector_first(arrays)) return std::nullopt;
  if (std::count_if(vector, arrays.end(), is_data_vector) > 1) {
    throw Error(name.path + " has several vectors: " + list_of(arrays) +
                "; choose one: " + name.path + ":" + vector->name);
  }
  return *find_array(read_csv_arrays(name.path), vector->name);
}

}  // namespace brindle::tool
