/// Named arrays of numbers that come with a mesh: what simulations store per point or per cell.
#pragma once

#include <array>
#include <cstddef>
#include <cstring>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "brindle/arrays.h"
#include "brindle/export.h"
#include "brindle/types.h"

namespace BRINDLE_EXPORT brindle {

/// A table of numbers, one row per point or per cell, of the type that they had in their file, so
/// that they are written as they were read.
struct DataArray {
  std::string name;
  NumberType type = NumberType::float32;
  int components = 1;            ///< numbers in a row, 1 or more
  std::vector<std::byte> bytes;  ///< the numbers, row by row, as this machine stores them
  /// Where rows of two or three numbers are means of others: the means of these as axes, v and -v
  /// being the same. Empty: `bytes` are that, too.
  std::vector<std::byte> axis_bytes = {};

  /// Rows that are complete.
  std::size_t rows() const;
  /// The table; valid as long as `bytes` is.
  ArrayView view() const;
  /// The table that directions without a sign are read from; valid as long as `axis_bytes`.
  ArrayView axes() const;

  bool operator==(const DataArray&) const = default;
};

/// Whether rows have as many numbers as directions: two or three.
bool may_be_axes(const DataArray& array);

/// Bytes of one number.
std::size_t size_of(NumberType type);

/// Throws Error if the numbers do not fill the last row.
template <ArrayNumber Number>
DataArray make_data_array(std::string name, int components, std::span<const Number> numbers) {
  const ArrayView view(numbers, static_cast<std::size_t>(components));  // checks the rows
  DataArray array{std::move(name), view.type(), components, {}};
  array.bytes.resize(numbers.size_bytes());
  if (!numbers.empty()) std::memcpy(array.bytes.data(), numbers.data(), numbers.size_bytes());
  return array;
}
template <ArrayNumber Number>
DataArray make_data_array(std::string name, int components, const std::vector<Number>& numbers) {
  return make_data_array(std::move(name), components, std::span<const Number>(numbers));
}

/// Three floats per vector.
DataArray make_data_array(std::string name, std::span<const Vec3> vectors);

/// The arrays of a mesh: those in `points` have a row per vertex, those in `cells` a row per
/// triangle.
struct DataArrays {
  std::vector<DataArray> points;
  std::vector<DataArray> cells;

  bool operator==(const DataArrays&) const = default;
};

/// The array of that name, or null.
const DataArray* find_array(std::span<const DataArray> arrays, std::string_view name);

/// Rows of `array` in the order of `rows`, any of them any number of times. Throws Error, naming
/// the array, for a row that it has not.
DataArray rows_of(const DataArray& array, std::span<const Index> rows);
std::vector<DataArray> rows_of(std::span<const DataArray> arrays, std::span<const Index> rows);

/// A point between three rows of an array: weights sum to 1.
struct RowBlend {
  std::array<Index, 3> rows;
  std::array<double, 3> weights;
};

/// An array with a row per blend: the weighted mean of floating-point numbers, and of rows of two
/// or three also that of axes; for whole numbers, which may be labels, the row with the largest
/// weight, the first of equal ones. A row with weight 0 does not count, even if it is NaN. Throws
/// Error, naming the array, for a row that it has not.
DataArray blended(const DataArray& array, std::span<const RowBlend> blends);
std::vector<DataArray> blended(std::span<const DataArray> arrays, std::span<const RowBlend> blends);

/// Statistics of an array.
struct ArrayFigures {
  double minimum = 0, maximum = 0;  ///< of all finite numbers; of rows with more than one component
                                    ///< the length of the vector. Both 0 if there are none
  std::size_t rows_nan = 0;         ///< rows with a component that is NaN
};

ArrayFigures measure_array(const DataArray& array);

/// "float32", "int64" and so on.
std::string_view name_of(NumberType type);

}  // namespace brindle
