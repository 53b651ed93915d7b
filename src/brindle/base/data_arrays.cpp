#include "brindle/data_arrays.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <type_traits>

#include "brindle/base/array_numbers.h"

namespace brindle {
namespace {

void check_row(const DataArray& array, Index row, std::size_t rows) {
  if (row < rows) return;
  throw Error("array '" + array.name + "': row " + std::to_string(row) + " of " +
              std::to_string(rows));
}

template <class Number>
Number number_at(const DataArray& array, std::size_t place) {
  Number number;
  std::memcpy(&number, &array.bytes[place * sizeof number], sizeof number);
  return number;
}

/// The row that stands for all where numbers cannot be mixed.
Index heaviest_row(const RowBlend& blend) {
  const auto heaviest = std::max_element(blend.weights.begin(), blend.weights.end());
  return blend.rows[static_cast<std::size_t>(heaviest - blend.weights.begin())];
}

template <class Number>
Number mean(const DataArray& array, const RowBlend& blend, std::size_t component) {
  const auto components = static_cast<std::size_t>(array.components);
  double sum = -0.0;  // to which -0 may be added and stay what it is
  for (std::size_t i = 0; i < 3; ++i) {
    if (blend.weights[i] == 0) continue;
    if (blend.weights[i] == 1)
      return number_at<Number>(array, blend.rows[i] * components + component);
    sum += blend.weights[i] * number_at<Number>(array, blend.rows[i] * components + component);
  }
  return static_cast<Number>(sum);
}

template <class Number>
void append_means(DataArray& result, const DataArray& array, std::span<const RowBlend> blends) {
  const auto components = static_cast<std::size_t>(array.components);
  const std::size_t rows = array.rows();
  result.bytes.resize(blends.size() * components * sizeof(Number));
  std::byte* out = result.bytes.data();
  for (const RowBlend& blend : blends) {
    for (const Index row : blend.rows) check_row(array, row, rows);
    for (std::size_t c = 0; c < components; ++c, out += sizeof(Number)) {
      const auto number = mean<Number>(array, blend, c);
      std::memcpy(out, &number, sizeof number);
    }
  }
}

}  // namespace

std::size_t size_of(NumberType type) {
  std::size_t size = 0;
  with_number_type(type, [&]<class Number>(Number) { size = sizeof(Number); });
  return size;
}

std::size_t DataArray::rows() const {
  return bytes.size() / (size_of(type) * static_cast<std::size_t>(components));
}

ArrayView DataArray::view() const {
  const auto size = static_cast<std::ptrdiff_t>(size_of(type));
  return {bytes.data(),      type, rows(), static_cast<std::size_t>(components),
          size * components, size};
}

DataArray make_data_array(std::string name, std::span<const Vec3> vectors) {
  static_assert(sizeof(Vec3) == 3 * sizeof(float));
  return make_data_array(
      std::move(name), 3,
      std::span(reinterpret_cast<const float*>(vectors.data()), 3 * vectors.size()));
}

const DataArray* find_array(std::span<const DataArray> arrays, std::string_view name) {
  const auto found = std::find_if(arrays.begin(), arrays.end(),
                                  [&](const DataArray& array) { return array.name == name; });
  return found == arrays.end() ? nullptr : &*found;
}

DataArray rows_of(const DataArray& array, std::span<const Index> rows) {
  DataArray result{array.name, array.type, array.components, {}};
  const std::size_t row_bytes = size_of(array.type) * static_cast<std::size_t>(array.components);
  const std::size_t count = array.rows();
  result.bytes.resize(rows.size() * row_bytes);
  std::byte* out = result.bytes.data();
  for (const Index row : rows) {
    check_row(array, row, count);
    std::memcpy(out, &array.bytes[row * row_bytes], row_bytes);
    out += row_bytes;
  }
  return result;
}

std::vector<DataArray> rows_of(std::span<const DataArray> arrays, std::span<const Index> rows) {
  std::vector<DataArray> result;
  for (const DataArray& array : arrays) result.push_back(rows_of(array, rows));
  return result;
}

DataArray blended(const DataArray& array, std::span<const RowBlend> blends) {
  if (!is_floating(array.type)) {
    std::vector<Index> rows(blends.size());
    std::transform(blends.begin(), blends.end(), rows.begin(), heaviest_row);
    return rows_of(array, rows);
  }
  DataArray result{array.name, array.type, array.components, {}};
  if (array.type == NumberType::float32) append_means<float>(result, array, blends);
  if (array.type == NumberType::float64) append_means<double>(result, array, blends);
  return result;
}

std::vector<DataArray> blended(std::span<const DataArray> arrays,
                               std::span<const RowBlend> blends) {
  std::vector<DataArray> result;
  for (const DataArray& array : arrays) result.push_back(blended(array, blends));
  return result;
}

ArrayFigures measure_array(const DataArray& array) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  ArrayFigures figures{kInfinity, -kInfinity, 0};
  const ArrayView view = array.view();
  double squares = 0;
  bool nan = false;
  for_each_number(view, [&](std::size_t, std::size_t column, auto number) {
    const auto value = static_cast<double>(number);
    if (column == 0) squares = 0, nan = false;
    nan = nan || std::isnan(value);
    squares += value * value;
    if (column + 1 < view.columns()) return;
    figures.rows_nan += nan;
    const double size = view.columns() == 1 ? value : std::sqrt(squares);
    if (!std::isfinite(size)) return;
    figures.minimum = std::min(figures.minimum, size);
    figures.maximum = std::max(figures.maximum, size);
  });
  if (figures.minimum > figures.maximum) figures.minimum = figures.maximum = 0;
  return figures;
}

std::string_view name_of(NumberType type) {
  switch (type) {
    case NumberType::float32:
      return "float32";
    case NumberType::float64:
      return "float64";
    case NumberType::int8:
      return "int8";
    case NumberType::uint8:
      return "uint8";
    case NumberType::int16:
      return "int16";
    case NumberType::uint16:
      return "uint16";
    case NumberType::int32:
      return "int32";
    case NumberType::uint32:
      return "uint32";
    case NumberType::int64:
      return "int64";
    case NumberType::uint64:
      return "uint64";
  }
  return "";
}

}  // namespace brindle
