#include "brindle/base/array_rows.h"

#include <algorithm>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

#include "brindle/error.h"

namespace brindle {
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
