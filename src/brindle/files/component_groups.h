/// Arrays of several components that a file has as one column of numbers per component.
#pragma once

#include <vector>

#include "brindle/data_arrays.h"

namespace brindle {

/// Joins columns, arrays of one component with equally many rows, that by their names are the
/// components of one array and have one type:
/// "velocity:0", "velocity:1" and so on, or "velocity_0", without a gap;
/// "velocity:x", "velocity:y" and "velocity:z", or "velocity_x", in small or capital letters;
/// "stress:xx", yy, zz, xy, yz, xz, which VTK's symmetric tensors have in this order;
/// "stress:xx", xy, xz, yx, yy, yz, zx, zy, zz.
/// Other columns stay as they are. Arrays stand in the order of their first columns.
std::vector<DataArray> grouped_columns(std::vector<DataArray> columns);

}  // namespace brindle
