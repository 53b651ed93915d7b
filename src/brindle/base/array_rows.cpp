#include "brindle/base/array_rows.h"

#include <algorithm>
#include <string>

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
  for (DataArray& array : arrays) {
    const std::size_t size = size_of(array.type) * static_cast<std::size_t>(array.components);
    for (std::size_t v = 0; v < partner.size(); ++v) {
      std::copy_n(array.bytes.data() + size * partner[v], partner[v] == v ? 0 : size,
                  array.bytes.data() + size * v);
    }
  }
}

}  // namespace brindle
