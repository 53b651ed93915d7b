/// Joins arrays of files from columns and from pieces.
#pragma once

#include <string>
#include <vector>

#include "brindle/data_arrays.h"

namespace brindle {

/// Joins columns (arrays of one component and equal length) of one type whose names mark them as
/// components of one array: "velocity:0", "velocity:1" ... or "velocity_0" ..., without a gap;
/// "velocity:x", "velocity:y" and "velocity:z", or "velocity_x" ..., or "vx", "vy" and "vz", in
/// either case; "stress:xx", yy, zz, xy, yz, xz, in VTK's order of symmetric tensors; "stress:xx",
/// xy, xz, yx, yy, yz, zx, zy, zz. Other columns stay. Arrays are in the order of their first
/// columns.
std::vector<DataArray> grouped_columns(std::vector<DataArray> columns);

/// The arrays of a file that stores them in pieces.
class PiecewiseArrays {
 public:
  /// Appends the rows of the next non-empty piece.
  void add(std::vector<DataArray> piece);

  /// The arrays that all pieces have, with one type and one number of components; adds a line to
  /// `left_out` for each other array. `of` names the owner of rows: "points".
  std::vector<DataArray> take(const std::string& of, std::string& left_out);

 private:
  std::vector<DataArray> arrays_;
  std::vector<std::string> incomplete_;
  bool begun_ = false;
};

/// Names unnamed arrays "unnamed", and numbers repeated names: "speed", "speed_2".
void make_names_unique(std::vector<DataArray>& arrays);

}  // namespace brindle
