/// Whether an array belongs to a mesh.
#pragma once

#include <cstddef>

#include "brindle/data_arrays.h"

namespace brindle {

/// Throw Error, naming the array, unless it has a row per vertex, or per triangle.
void check_rows_per_vertex(const DataArray& array, std::size_t vertices);
void check_rows_per_triangle(const DataArray& array, std::size_t triangles);

}  // namespace brindle
