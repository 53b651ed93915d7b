/// Views of other programs' arrays in memory: vertex buffers, numpy, VTK, CAD kernels.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <type_traits>
#include <vector>

#include "brindle/export.h"
#include "brindle/types.h"

namespace BRINDLE_EXPORT brindle {

/// The number types of an ArrayView.
enum class NumberType : std::uint8_t {
  float32,
  float64,
  int8,
  uint8,
  int16,
  uint16,
  int32,
  uint32,
  int64,
  uint64
};

/// A number that has a NumberType.
template <class Number>
concept ArrayNumber = std::is_arithmetic_v<Number> && !std::is_same_v<Number, bool> &&
                      !std::is_same_v<Number, long double>;

template <ArrayNumber Number>
constexpr NumberType number_type() {
  if constexpr (std::is_floating_point_v<Number>) {
    return sizeof(Number) == 4 ? NumberType::float32 : NumberType::float64;
  } else {
    constexpr int exponent = sizeof(Number) == 1   ? 0
                             : sizeof(Number) == 2 ? 1
                             : sizeof(Number) == 4 ? 2
                                                   : 3;
    return static_cast<NumberType>(static_cast<int>(NumberType::int8) + 2 * exponent +
                                   (std::is_unsigned_v<Number> ? 1 : 0));
  }
}

/// A non-owning view of a table of numbers of any type; the memory must outlive the view. Functions
/// that take a view check and copy its numbers, and keep no reference.
class ArrayView {
 public:
  /// No rows.
  ArrayView() = default;

  /// `rows` times `columns` numbers. Strides are in bytes and may be negative; 0 stands for packed
  /// rows of packed numbers.
  template <ArrayNumber Number>
  ArrayView(const Number* data, std::size_t rows, std::size_t columns,
            std::ptrdiff_t row_stride = 0, std::ptrdiff_t column_stride = 0)
      : ArrayView(
            data, number_type<Number>(), rows, columns,
            row_stride != 0 ? row_stride : static_cast<std::ptrdiff_t>(columns * sizeof(Number)),
            column_stride != 0 ? column_stride : static_cast<std::ptrdiff_t>(sizeof(Number))) {}

  /// As above, for a type known only at run time. Strides of 0 are used as given.
  ArrayView(const void* data, NumberType type, std::size_t rows, std::size_t columns,
            std::ptrdiff_t row_stride, std::ptrdiff_t column_stride)
      : data_(static_cast<const std::byte*>(data)),
        rows_(rows),
        columns_(columns),
        row_stride_(row_stride),
        column_stride_(column_stride),
        type_(type) {}

  /// Packed rows of `columns` numbers. Throws Error if the numbers do not fill the last row.
  template <ArrayNumber Number>
  ArrayView(std::span<const Number> numbers, std::size_t columns)
      : ArrayView(numbers.data(), whole_rows(numbers.size(), columns), columns) {}
  template <ArrayNumber Number>
  ArrayView(const std::vector<Number>& numbers, std::size_t columns)
      : ArrayView(std::span<const Number>(numbers), columns) {}

  /// One row of three numbers per vector.
  ArrayView(std::span<const Vec3> vectors)  // NOLINT(google-explicit-constructor)
      : ArrayView(reinterpret_cast<const float*>(vectors.data()), vectors.size(), 3) {}
  ArrayView(const std::vector<Vec3>& vectors)  // NOLINT(google-explicit-constructor)
      : ArrayView(std::span<const Vec3>(vectors)) {}

  std::size_t rows() const { return rows_; }
  std::size_t columns() const { return columns_; }
  NumberType type() const { return type_; }
  const std::byte* address(std::size_t row, std::size_t column) const {
    return data_ + static_cast<std::ptrdiff_t>(row) * row_stride_ +
           static_cast<std::ptrdiff_t>(column) * column_stride_;
  }

 private:
  /// Throws Error if `count` is no multiple of `columns`.
  static std::size_t whole_rows(std::size_t count, std::size_t columns);

  const std::byte* data_ = nullptr;
  std::size_t rows_ = 0;
  std::size_t columns_ = 0;
  std::ptrdiff_t row_stride_ = 0;
  std::ptrdiff_t column_stride_ = 0;
  NumberType type_ = NumberType::float32;
};

/// Copies of tables with three columns or one; numbers are converted to double, then to float.
/// `what` names the array in messages ("directions"). Throw Error for another number of columns.
std::vector<Vec3> vectors_of(const ArrayView& array, std::string_view what);
std::vector<float> numbers_of(const ArrayView& array, std::string_view what);

}  // namespace brindle
