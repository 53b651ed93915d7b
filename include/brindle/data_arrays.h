/// Named arrays of numbers of a mesh, one row per point or per cell, as simulations store them.
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

/// A table of numbers, one row per point or per cell. It keeps the number type of its file, so that
/// it is written as it was read.
struct DataArray {
  std::string name;
  NumberType type = NumberType::float32;
  int components = 1;            ///< numbers in a row, 1 or more
  std::vector<std::byte> bytes;  ///< the numbers, row by row, in native byte order
  /// For rows of two or three numbers that are means of others: the means as axes, where v and -v
  /// are equal. Empty: `bytes` serve as these, too.
  std::vector<std::byte> axis_bytes = {};

  /// The number of complete rows.
  std::size_t rows() const;
  /// The table; valid as long as `bytes` is.
  ArrayView view() const;
  /// The table for directions without a sign; valid as long as `axis_bytes` and `bytes` are.
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

/// Rows of `array` by number, in any order and any number of times. Throws Error, naming the array,
/// for a number out of range.
DataArray rows_of(const DataArray& array, std::span<const Index> rows);
std::vector<DataArray> rows_of(std::span<const DataArray> arrays, std::span<const Index> rows);

/// A point between three rows of an array; weights sum to 1.
struct RowBlend {
  std::array<Index, 3> rows;
  std::array<double, 3> weights;
};

/// An array with one row per blend. Floating-point numbers become weighted means; rows of two or
/// three also get means as axes. Whole numbers, which may be labels, come from the row with the
/// largest weight, the first of equal ones. Rows of weight 0 do not count, even if NaN. Throws
/// Error, naming the array, for a row out of range.
DataArray blended(const DataArray& array, std::span<const RowBlend> blends);
std::vector<DataArray> blended(std::span<const DataArray> arrays, std::span<const RowBlend> blends);

/// Statistics of an array.
struct ArrayMetrics {
  double minimum = 0, maximum = 0;  ///< of all finite numbers, or of the magnitudes of rows with
                                    ///< several components; 0 if there are none
  std::size_t rows_nan = 0;         ///< rows with a component that is NaN
};

ArrayMetrics measure_array(const DataArray& array);

/// The name of a type, such as "float32".
std::string_view name_of(NumberType type);

}  // namespace brindle
