/// Files with rows and columns of numbers.
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "brindle/base/input_file.h"
#include "brindle/data_arrays.h"

namespace brindle {

/// Terms in messages about a kind of file: "field", "x,y,z or x,y,z,frequency".
struct CsvKind {
  std::string what;
  std::string columns;
};

/// The start of messages about a row: "'path', line 7: ".
std::string at_line(const std::filesystem::path& path, std::size_t line);

/// Receives the numbers of a row; lines count from 1.
using CsvRowUse = std::function<void(std::size_t line, std::span<const double> values)>;

/// Whether a name is among these, ignoring case.
bool has_column(std::span<const std::string> names, std::string_view name);

/// Numeric columns, named by the first row.
struct CsvTable {
  std::vector<DataArray> columns;  ///< float64, one component each
  std::vector<std::size_t> lines;  ///< the line of each row

  std::vector<std::string> names() const;

  /// Calls `use` for each row with the numbers of these existing columns: the first of each name,
  /// ignoring case.
  void for_each_row(std::span<const std::string_view> names, const CsvRowUse& use) const;
};

/// A file, read in one pass. Commas, semicolons, tabs or spaces separate columns; cells may be
/// quoted. A byte-order mark, empty lines and lines that begin with # are skipped. nan and inf are
/// numbers; numbers beyond the range of double become infinite or zero. All functions throw Error
/// with the file, the line, the column's name if any, and the remedy.
class CsvFile {
 public:
  CsvFile(std::filesystem::path path, CsvKind kind);

  /// The first row if none of its cells is a number; else empty.
  const std::vector<std::string>& names() const { return names_; }

  /// Calls `use` for each row of numbers; skips a first row of words. Throws Error for words in
  /// other rows, and errors of `use`.
  void read(const CsvRowUse& use);

  /// All rows below the names. Columns that begin with a word are left out; empty cells are NaN.
  /// Throws Error without names or numbers, for words in numeric columns, and for rows that are
  /// longer or shorter than the names.
  CsvTable read_table();

 private:
  /// The next non-empty row; false after the last.
  bool next_row();
  [[noreturn]] void refuse_row() const;
  [[noreturn]] void refuse_cell(std::size_t column) const;

  std::filesystem::path path_;
  CsvKind kind_;
  InputLines in_;
  std::string line_;
  std::string_view row_;  ///< of `line_`
  std::size_t number_ = 0;
  bool first_ = false;  ///< `row_` is the first row, not used yet
  std::vector<std::string> names_;
  std::vector<std::string_view> cells_;  ///< of `row_`
};

}  // namespace brindle
