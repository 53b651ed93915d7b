/// Selects arrays by the names that users give.
#pragma once

#include <span>
#include <string>

#include "brindle/data_arrays.h"

namespace brindle {

/// "velocity (3), speed".
std::string list_of(std::span<const DataArray> arrays);

struct ArrayChoice {
  const DataArray* array = nullptr;  ///< one of the given arrays
  bool of_cells = false;
};

/// The array NAME, points/NAME or cells/NAME. Throws Error for another name, with `file` and all
/// available arrays.
ArrayChoice choice_of(const DataArrays& arrays, const std::string& name, const std::string& file);

/// The same, copied.
DataArray array_named(const DataArrays& arrays, const std::string& name, const std::string& file);

/// The arrays of several names, each once.
DataArrays named_arrays(const DataArrays& arrays, std::span<const std::string> names,
                        const std::string& file);

}  // namespace brindle
