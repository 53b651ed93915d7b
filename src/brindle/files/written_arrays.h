/// Converts arrays to the form of file formats.
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

/// The same numbers in another type; empty if one changes.
std::optional<DataArray> exactly_as(const DataArray& array, NumberType type);

/// Replaces everything but letters, digits and underscores by underscores.
std::string one_word(std::string_view name);

/// A name per component: NAME alone, NAME_x to NAME_z of three, NAME_0 ... of others.
std::vector<std::string> column_names(const DataArray& array);

/// Appends underscores to the array's name until none of its columns is `taken`, and adds them to
/// `taken`.
DataArray with_free_columns(DataArray array, std::vector<std::string>& taken);

/// Arrays as columns of a file of lines or samples, whose own columns are `taken`. Throws Error
/// with the file for arrays that the file cannot hold or that do not have `rows` rows.
std::vector<DataArray> fitted_columns(const std::filesystem::path& path,
                                      std::span<const DataArray> arrays, std::size_t rows,
                                      std::vector<std::string> taken);

/// Throws Error with the file unless every array has `rows` rows, one per `of`.
void check_rows(const std::filesystem::path& path, std::span<const DataArray> arrays,
                std::size_t rows, const char* of);

/// Throws the error for arrays that a file cannot hold.
[[noreturn]] void refuse_array(const std::filesystem::path& path, const std::string& left_out);

}  // namespace brindle
