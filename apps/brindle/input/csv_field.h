/// Fields in CSV files with named columns.
#pragma once

#include <optional>
#include <span>
#include <string>

#include "brindle/data_arrays.h"
#include "brindle/files.h"
#include "brindle/surface.h"

namespace brindle::tool {

/// "wind.csv" or "wind.csv:velocity".
struct CsvFieldName {
  std::string path;
  std::string array;  ///< empty if not given
};

CsvFieldName csv_field_name(const std::string& field);

struct CsvField {
  DataArray array;                     ///< vectors or tensors; two components for `of_globe`
  bool of_globe = false;               ///< east and north components
  std::optional<DataArray> frequency;  ///< the column of this name, if any
};

/// The field array: the one named, or the columns `east` and `north`, or the only vector or,
/// without any, the only tensor. Empty for files of `read_field_csv`: those without such arrays, or
/// with the components of a vector in the first columns and at most two numbers after it. Throws
/// Error with all arrays for an unknown name, and for several arrays without a name.
std::optional<CsvField> read_csv_field(const CsvFieldName& name);

/// `read_field_csv`, with rows copied to the vertices that creases split off.
FieldFile read_rows(const Surface& surface, const std::string& path,
                    std::span<const Index> vertex_of_row);

/// An array of a file's vertices, with rows for copies at creases.
DataArray with_copies(const Surface& surface, const DataArray& array);

}  // namespace brindle::tool
