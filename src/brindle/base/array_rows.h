/// Checks and copies of rows of arrays that belong to a mesh.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "brindle/data_arrays.h"
#include "brindle/types.h"

namespace brindle {

/// Throw Error, naming the array, unless it has one row per vertex, or per triangle.
void check_rows_per_vertex(const DataArray& array, std::size_t vertices);
void check_rows_per_triangle(const DataArray& array, std::size_t triangles);

/// Copies row partner[v] to every row v with an entry in `partner`; other rows stay. For vertices
/// without own values that were joined with another at the same position. Arrays have a row for
/// every entry.
void copy_from_partners(std::span<DataArray> arrays, std::span<const Index> partner);

/// Sets the axis means, rows of the array's own type, unless they equal the array's numbers.
void set_axes(DataArray& array, std::vector<std::byte> axes);

}  // namespace brindle
