/// Access to the numbers of an ArrayView of any type.
#pragma once

#include <cstring>
#include <string>
#include <vector>

#include "brindle/arrays.h"
#include "brindle/error.h"

namespace brindle {

/// Throws Error unless the array is empty or has this number of columns.
inline void check_columns(const ArrayView& array, std::size_t columns, std::string_view what) {
  if (array.rows() == 0 || array.columns() == columns) return;
  throw Error(std::string(what) + ": an array of " + std::to_string(array.rows()) + " x " +
              std::to_string(array.columns()) + " numbers; it must have " +
              std::to_string(columns) + (columns == 1 ? " column" : " columns"));
}

inline bool is_floating(NumberType type) {
  return type == NumberType::float32 || type == NumberType::float64;
}

/// Calls `use(Number())` with the type of the array's numbers.
template <class Use>
void with_number_type(NumberType type, const Use& use) {
  switch (type) {
    case NumberType::float32:
      return use(float());
    case NumberType::float64:
      return use(double());
    case NumberType::int8:
      return use(std::int8_t());
    case NumberType::uint8:
      return use(std::uint8_t());
    case NumberType::int16:
      return use(std::int16_t());
    case NumberType::uint16:
      return use(std::uint16_t());
    case NumberType::int32:
      return use(std::int32_t());
    case NumberType::uint32:
      return use(std::uint32_t());
    case NumberType::int64:
      return use(std::int64_t());
    case NumberType::uint64:
      return use(std::uint64_t());
  }
}

/// Calls `use(row, column, number)` for all numbers, row by row; addresses may be unaligned.
template <class Use>
void for_each_number(const ArrayView& array, const Use& use) {
  with_number_type(array.type(), [&]<class Number>(Number) {
    for (std::size_t row = 0; row < array.rows(); ++row) {
      for (std::size_t column = 0; column < array.columns(); ++column) {
        Number number;
        std::memcpy(&number, array.address(row, column), sizeof number);
        use(row, column, number);
      }
    }
  });
}

/// All numbers, row by row.
inline std::vector<double> doubles_of(const ArrayView& array) {
  std::vector<double> numbers;
  numbers.reserve(array.rows() * array.columns());
  for_each_number(array, [&](std::size_t, std::size_t, auto number) {
    numbers.push_back(static_cast<double>(number));
  });
  return numbers;
}

}  // namespace brindle
