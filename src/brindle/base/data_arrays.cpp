#include "brindle/data_arrays.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

#include "brindle/arrays.h"
#include "brindle/base/array_numbers.h"
#include "brindle/base/array_rows.h"
#include "brindle/base/axis_mean.h"
#include "brindle/base/parallel.h"
#include "brindle/error.h"

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

/// The row of largest weight, for numbers that cannot be averaged.
Index heaviest_row(const RowBlend& blend) {
  const auto heaviest = std::max_element(blend.weights.begin(), blend.weights.end());
  return blend.rows[static_cast<std::size_t>(heaviest - blend.weights.begin())];
}

template <class Number>
Number mean(const DataArray& array, const RowBlend& blend, std::size_t component) {
  const auto components = static_cast<std::size_t>(array.components);
  double sum = -0.0;  // so that a sum of -0 stays -0
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

template <class Number>
Eigen::Vector3d vector_at(const ArrayView& axes, Index row) {
  Eigen::Vector3d vector = Eigen::Vector3d::Zero();
  for (std::size_t c = 0; c < axes.columns(); ++c) {
    Number number;
    std::memcpy(&number, axes.address(row, c), sizeof number);
    vector[static_cast<Eigen::Index>(c)] = number;
  }
  return vector;
}

/// Replaces rows of `means` whose axes have to be turned to one side first.
template <class Number>
void mend_means(const DataArray& array, std::span<const RowBlend> blends,
                std::vector<std::byte>& means) {
  const ArrayView rows = array.axes();
  const std::size_t row_bytes = rows.columns() * sizeof(Number);
  parallel_for(blends.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      std::array<WeightedAxis, 3> axes;
      std::size_t count = 0;
      for (std::size_t k = 0; k < 3; ++k) {
        const double weight = blends[i].weights[k];
        if (weight == 0) continue;
        axes[count++] = {vector_at<Number>(rows, blends[i].rows[k]), weight};
      }
      const auto mean = mean_of_turned(std::span(axes).first(count));
      if (!mean) continue;
      const Eigen::Matrix<Number, 3, 1> axis = mean->template cast<Number>();
      std::memcpy(&means[i * row_bytes], axis.data(), row_bytes);
    }
  });
}

std::vector<std::byte> chosen_rows(const std::vector<std::byte>& bytes, std::size_t row_bytes,
                                   std::span<const Index> rows) {
  std::vector<std::byte> result(rows.size() * row_bytes);
  std::byte* out = result.data();
  for (const Index row : rows) {
    std::memcpy(out, &bytes[row * row_bytes], row_bytes);
    out += row_bytes;
  }
  return result;
}

ArrayView view_of(const DataArray& array, const std::vector<std::byte>& bytes) {
  const auto size = static_cast<std::ptrdiff_t>(size_of(array.type));
  return {bytes.data(),
          array.type,
          array.rows(),
          static_cast<std::size_t>(array.components),
          size * array.components,
          size};
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

ArrayView DataArray::view() const { return view_of(*this, bytes); }

ArrayView DataArray::axes() const {
  return view_of(*this, axis_bytes.empty() ? bytes : axis_bytes);
}

DataArray make_data_array(std::string name, std::span<const Vec3> vectors) {
  static_assert(sizeof(Vec3) == 3 * sizeof(float));
  return make_data_array(
      std::move(name), 3,
      std::span(reinterpret_cast<const float*>(vectors.data()), 3 * vectors.size()));
}

bool may_be_axes(const DataArray& array) { return array.components == 2 || array.components == 3; }

const DataArray* find_array(std::span<const DataArray> arrays, std::string_view name) {
  const auto found = std::find_if(arrays.begin(), arrays.end(),
                                  [&](const DataArray& array) { return array.name == name; });
  return found == arrays.end() ? nullptr : &*found;
}

DataArray rows_of(const DataArray& array, std::span<const Index> rows) {
  DataArray result{array.name, array.type, array.components, {}};
  const std::size_t row_bytes = size_of(array.type) * static_cast<std::size_t>(array.components);
  const std::size_t count = array.rows();
  for (const Index row : rows) check_row(array, row, count);
  result.bytes = chosen_rows(array.bytes, row_bytes, rows);
  if (!array.axis_bytes.empty()) result.axis_bytes = chosen_rows(array.axis_bytes, row_bytes, rows);
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
  const bool single = array.type == NumberType::float32;
  const auto means_of = [&](const DataArray& rows) {
    DataArray means{rows.name, rows.type, rows.components, {}};
    single ? append_means<float>(means, rows, blends) : append_means<double>(means, rows, blends);
    return means;
  };
  DataArray result = means_of(array);
  if (!may_be_axes(array)) return result;
  std::vector<std::byte> axes = result.bytes;
  if (!array.axis_bytes.empty()) {
    axes = means_of({array.name, array.type, array.components, array.axis_bytes}).bytes;
  }
  single ? mend_means<float>(array, blends, axes) : mend_means<double>(array, blends, axes);
  set_axes(result, std::move(axes));
  return result;
}

std::vector<DataArray> blended(std::span<const DataArray> arrays,
                               std::span<const RowBlend> blends) {
  std::vector<DataArray> result;
  for (const DataArray& array : arrays) result.push_back(blended(array, blends));
  return result;
}

ArrayMetrics measure_array(const DataArray& array) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  ArrayMetrics metrics{kInfinity, -kInfinity, 0};
  const ArrayView view = array.view();
  double squares = 0;
  bool nan = false;
  for_each_number(view, [&](std::size_t, std::size_t column, auto number) {
    const auto value = static_cast<double>(number);
    if (column == 0) squares = 0, nan = false;
    nan = nan || std::isnan(value);
    squares += value * value;
    if (column + 1 < view.columns()) return;
    metrics.rows_nan += nan;
    const double size = view.columns() == 1 ? value : std::sqrt(squares);
    if (!std::isfinite(size)) return;
    metrics.minimum = std::min(metrics.minimum, size);
    metrics.maximum = std::max(metrics.maximum, size);
  });
  if (metrics.minimum > metrics.maximum) metrics.minimum = metrics.maximum = 0;
  return metrics;
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

namespace {

void check_row_count(const DataArray& array, std::size_t rows, const std::string& one,
                     const std::string& many) {
  if (array.rows() == rows) return;
  throw Error("array '" + array.name + "' has " + std::to_string(array.rows()) + " rows for " +
              std::to_string(rows) + " " + many + "; give one row per " + one);
}

}  // namespace

void check_rows_per_vertex(const DataArray& array, std::size_t vertices) {
  check_row_count(array, vertices, "vertex", "vertices");
}

void check_rows_per_triangle(const DataArray& array, std::size_t triangles) {
  check_row_count(array, triangles, "triangle", "triangles");
}

void copy_from_partners(std::span<DataArray> arrays, std::span<const Index> partner) {
  std::vector<Index> rows;
  for (DataArray& array : arrays) {
    rows.resize(array.rows());
    std::iota(rows.begin(), rows.end(), Index{0});
    std::copy(partner.begin(), partner.end(), rows.begin());
    array = rows_of(array, rows);
  }
}

void set_axes(DataArray& array, std::vector<std::byte> axes) {
  if (axes != array.bytes) array.axis_bytes = std::move(axes);
}

}  // namespace brindle
