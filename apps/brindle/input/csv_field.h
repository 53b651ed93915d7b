/// Fields in CSV files whose first row names their columns.
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
  std::string array;  ///< empty if there is none
};

CsvFieldName csv_field_name(const std::string& field);

struct CsvField {
  DataArray array;                     ///< vectors, or tensors; two numbers a row of a globe
  bool of_globe = false;               ///< towards the east and the north
  std::optional<DataArray> frequency;  ///< the column of this name, if there is one
};

/// The array that is the field: that of the name, or else the columns `east` and `north`, or else
/// the only vector or, without any, the only tensor. Nothing for a file that `read_field_csv` is
/// for: one without such arrays, or with a vector first, its components in order, and at most two
/// numbers behind it. Throws Error, naming all arrays, for another name, and if there are several
/// and no name.
std::optional<CsvField> read_csv_field(const CsvFieldName& name);

/// `read_field_csv`, with the rows of vertices that creases have split for all their copies.
FieldFile read_rows(const Surface& surface, const std::string& path,
                    std::span<const Index> vertex_of_row);

/// An array of a file's vertices, with rows for copies at creases.
DataArray with_copies(const Surface& surface, const DataArray& array);

}  // namespace brindle::tool
