/// Arrays as files hold them, put together: of columns, and of pieces.
#pragma once

#include <string>
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

/// The arrays of a file that stores them in pieces.
class PiecewiseArrays {
 public:
  /// Appends the rows of the next piece, which has at least one.
  void add(std::vector<DataArray> piece);

  /// The arrays that every piece has, with one type and one number of components; `left_out`
  /// receives a line for each other. `of` is what rows belong to: "points".
  std::vector<DataArray> take(const std::string& of, std::string& left_out);

 private:
  std::vector<DataArray> arrays_;
  std::vector<std::string> incomplete_;
  bool begun_ = false;
};

/// Gives arrays without a name the name "unnamed", and those whose name an earlier one has a number
/// behind it: "speed", "speed_2".
void make_names_unique(std::vector<DataArray>& arrays);

}  // namespace brindle
