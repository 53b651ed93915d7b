/// Arrays of files that give them in pieces, put together.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "brindle/data_arrays.h"

namespace brindle {

class PiecewiseArrays {
 public:
  /// Appends the rows of the next piece, which has at least one.
  void add(std::vector<DataArray> piece);

  /// Those arrays that every piece has, with one type and one number of components; `left_out`
  /// receives a line per other one. `of` says what rows belong to: "points".
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
