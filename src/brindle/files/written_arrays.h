/// How arrays are stored in files.
#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "brindle/base/output_file.h"
#include "brindle/data_arrays.h"
#include "brindle/files/binary_output.h"

namespace brindle {

/// The same numbers in another type; nothing unless all are what they were.
std::optional<DataArray> exactly_as(const DataArray& array, NumberType type);

/// Letters, digits and underscores; anything else is an underscore.
std::string one_word(std::string_view name);

/// A name for each component: NAME alone, NAME_x to NAME_z of three, NAME_0 and on of others.
std::vector<std::string> column_names(const DataArray& array);

/// An array whose name makes columns that are not `taken` yet, with underscores at its end; then
/// they are.
DataArray with_free_columns(DataArray array, std::vector<std::string>& taken);

/// Arrays for columns of a file of lines or samples, whose own columns are `taken`. Throws Error,
/// naming the file, for arrays without `rows` rows, and for those that it cannot hold.
std::vector<DataArray> fitted_columns(const std::filesystem::path& path,
                                      std::span<const DataArray> arrays, std::size_t rows,
                                      std::vector<std::string> taken);

/// Throws Error, naming the file, unless every array has a row for each `of` what there are `rows`.
void check_rows(const std::filesystem::path& path, std::span<const DataArray> arrays,
                std::size_t rows, const char* of);

/// The error of arrays that a file cannot hold.
[[noreturn]] void refuse_array(const std::filesystem::path& path, const std::string& left_out);

/// A name as a CSV file has it: between quotation marks if it must be.
std::string csv_name(std::string_view name);

/// The numbers of a row, each behind a comma.
void put_csv_row(TextOutput& text, const DataArray& array, std::size_t row);

/// The lines of a .ply file's header for one array of fitting names and types, and what they say of
/// a row: "uv" is there twice.
void put_ply_properties(OutputStream& out, const DataArray& array);
void put_ply_row(BinaryOutput& binary, const DataArray& array, std::size_t row);

}  // namespace brindle
