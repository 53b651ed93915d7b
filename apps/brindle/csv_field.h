/// Fields in CSV files whose first row names their columns.
#pragma once

#include <optional>
#include <string>

#include "brindle/data_arrays.h"

namespace brindle::tool {

/// "wind.csv" or "wind.csv:velocity".
struct CsvFieldName {
  std::string path;
  std::string array;  ///< empty if there is none
};

CsvFieldName csv_field_name(const std::string& field);

/// The array that is the field: that of the name, or else the only one of three numbers. Nothing
/// for a file that `read_field_csv` is for: one without such arrays, or with a vector first and at
/// most two numbers behind it. Throws Error, naming all arrays, for another name, and if there are
/// several vectors and no name.
std::optional<DataArray> csv_field_array(const CsvFieldName& name);

}  // namespace brindle::tool
