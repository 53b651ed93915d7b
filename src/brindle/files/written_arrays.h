/// Arrays in the form of the files that they are written to.
#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "brindle/base/output_file.h"
#include "brindle/data_arrays.h"

namespace brindle {

/// The same numbers in another type; nothing unless all keep their values.
std::optional<DataArray> exactly_as(const DataArray& array, NumberType type);

/// The name with underscores for everything but letters, digits and underscores.
std::string one_word(std::string_view name);

/// A name for each component: NAME alone, NAME_x to NAME_z of three, NAME_0 and on of others.
std::vector<std::string> column_names(const DataArray& array);

/// The array with underscores at the end of its name until none of its columns is `taken`, to which
/// they are added.
DataArray with_free_columns(DataArray array, std::vector<std::string>& taken);

/// Arrays for columns of a file of lines or samples, whose own columns are `taken`. Throws Error,
/// naming the file, for arrays that have not `rows` rows or that the file cannot hold.
std::vector<DataArray> fitted_columns(const std::filesystem::path& path,
                                      std::span<const DataArray> arrays, std::size_t rows,
                                      std::vector<std::string> taken);

/// Throws Error, naming the file, unless every array has `rows` rows, one for every `of`.
void check_rows(const std::filesystem::path& path, std::span<const DataArray> arrays,
                std::size_t rows, const char* of);

/// The error of arrays that a file cannot hold.
[[noreturn]] void refuse_array(const std::filesystem::path& path, const std::string& left_out);

}  // namespace brindle
