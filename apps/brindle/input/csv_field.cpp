#include "input/csv_field.h"

#include <algorithm>
#include <filesystem>
#include <utility>
#include <vector>

#include "brindle/base/array_numbers.h"
#include "brindle/base/text.h"
#include "brindle/error.h"
#include "brindle/files.h"
#include "brindle/tensor_field.h"
#include "input/array_source.h"

namespace brindle::tool {
namespace {

/// Files of points have normals, in columns nx, ny and nz, and ParaView's positions, too.
bool is_data_vector(const DataArray& array) {
  return array.components == 3 && array.name != "Points" && array.name != "Normals" &&
         array.name != "n";
}

/// Whether only frequencies follow the vector, as in files without names.
bool has_vector_first(const std::vector<DataArray>& arrays) {
  const DataArray in_order = make_data_array(arrays[0].name, 3, std::vector<double>{0, 1, 2});
  const auto is = [&](std::size_t place, const char* name) {
    return arrays.size() <= place || arrays[place].name == name;
  };
  return arrays[0] == in_order && arrays.size() <= 3 && is(1, "frequency") && is(2, "frequency_v");
}

constexpr const char* kEast = "east";
constexpr const char* kNorth = "north";

/// Columns of one number with these names, in files whose vectors are identified that way.
bool has_east_and_north(const std::vector<DataArray>& arrays) {
  const auto is_there = [&](const char* name) {
    const DataArray* found = find_array(arrays, name);
    return found != nullptr && found->components == 1;
  };
  return is_there(kEast) && is_there(kNorth);
}

DataArray east_and_north(const DataArrays& arrays) {
  const std::vector<double> east = doubles_of(find_array(arrays.points, kEast)->view());
  const std::vector<double> north = doubles_of(find_array(arrays.points, kNorth)->view());
  std::vector<double> rows;
  for (std::size_t row = 0; row < east.size(); ++row) {
    rows.insert(rows.end(), {east[row], north[row]});
  }
  return make_data_array("east and north", 2, rows);
}

/// Pipes can be opened only once and are not examined.
bool is_regular(const std::string& path) {
  std::error_code ignored;
  return std::filesystem::is_regular_file(path, ignored);
}

bool is_of_globe(const std::string& path) {
  return is_regular(path) && has_east_and_north(csv_columns(path));
}

/// The only vector or, without any, the only tensor. Empty if there is neither, or if a vector is
/// in the first columns, as in files without names.
std::string only_field_in(const std::string& path) {
  if (!is_regular(path)) return "";
  const std::vector<DataArray> arrays = csv_columns(path);
  if (arrays.empty() || has_vector_first(arrays)) return "";
  for (const auto& [is_field, many] :
       {std::pair(&is_data_vector, "vectors"), std::pair(&is_tensor, "tensors")}) {
    const auto field = std::find_if(arrays.begin(), arrays.end(), is_field);
    if (field == arrays.end()) continue;
    if (std::count_if(field, arrays.end(), is_field) == 1) return field->name;
    throw Error(shown(path) + " has several " + many + ": " + list_of(arrays) +
                "; choose one: " + shown(path) + ":" + field->name);
  }
  return "";
}

}  // namespace

CsvFieldName csv_field_name(const std::string& field) {
  std::error_code ignored;
  const std::size_t colon = field.rfind(".csv:");
  if (colon == std::string::npos || std::filesystem::exists(field, ignored)) return {field, ""};
  return {field.substr(0, colon + 4), field.substr(colon + 5)};
}

std::optional<CsvField> read_csv_field(const CsvFieldName& name) {
  std::string array = name.array;
  const bool of_globe = array.empty() && is_of_globe(name.path);
  if (array.empty() && !of_globe) {
    array = only_field_in(name.path);
    if (array.empty()) return std::nullopt;
  }
  const DataArrays arrays{read_csv_arrays(name.path), {}};
  CsvField field{
      of_globe ? east_and_north(arrays) : array_named(arrays, array, name.path), of_globe, {}};
  const DataArray* frequency = find_array(arrays.points, "frequency");
  if (frequency != nullptr && frequency->components == 1) field.frequency = *frequency;
  return field;
}

FieldFile read_rows(const Surface& surface, const std::string& path,
                    std::span<const Index> vertex_of_row) {
  FieldFile file = read_field_csv(path, surface.own_vertex_count(), vertex_of_row);
  add_rows_of_copies(surface.creases, file.vectors);
  add_rows_of_copies(surface.creases, file.frequencies);
  add_rows_of_copies(surface.creases, file.frequencies_v);
  return file;
}

DataArray with_copies(const Surface& surface, const DataArray& array) {
  if (surface.creases.empty() || array.rows() != surface.own_vertex_count()) return array;
  DataArrays arrays{{array}, {}};
  add_rows_of_copies(surface.creases, arrays);
  return arrays.points.front();
}

}  // namespace brindle::tool
