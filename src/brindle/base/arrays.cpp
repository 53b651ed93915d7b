#include "brindle/arrays.h"

#include "brindle/base/array_numbers.h"

namespace brindle {

std::size_t ArrayView::whole_rows(std::size_t count, std::size_t columns) {
  if (columns > 0 && count % columns == 0) return count / columns;
  throw Error("an array of " + std::to_string(count) + " numbers has no rows of " +
              std::to_string(columns) + " each");
}

std::vector<Vec3> vectors_of(const ArrayView& array, std::string_view what) {
  check_columns(array, 3, what);
  std::vector<Vec3> vectors(array.rows());
  for_each_number(array, [&](std::size_t row, std::size_t column, auto number) {
    vectors[row][static_cast<int>(column)] = static_cast<float>(number);
  });
  return vectors;
}

std::vector<float> numbers_of(const ArrayView& array, std::string_view what) {
  check_columns(array, 1, what);
  std::vector<float> numbers(array.rows());
  for_each_number(array, [&](std::size_t row, std::size_t, auto number) {
    numbers[row] = static_cast<float>(number);
  });
  return numbers;
}

}  // namespace brindle
