/// Files of numbers in rows and columns.
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "brindle/base/input_file.h"
#include "brindle/data_arrays.h"

namespace brindle {

/// The words of messages for a kind of file: "field", "x,y,z or x,y,z,frequency".
struct CsvKind {
  std::string what;
  std::string columns;
};

/// The beginning of messages on a row: "'path', line 7: ".
std::string at_line(const std::filesystem::path& path, std::size_t line);

/// Called with the numbers of a row; lines are counted from 1.
using CsvRowUse = std::function<void(std::size_t line, std::span<const double> values)>;

/// Whether a name is among these, in small or capital letters.
bool has_column(std::span<const std::string> names, std::string_view name);

/// Columns of numbers that the first row names.
struct CsvTable {
  std::vector<DataArray> columns;  ///< float64, one component each
  std::vector<std::size_t> lines;  ///< the line of each row

  std::vector<std::string> names() const;

  /// Calls `use` for every row with the numbers of the columns of these names, which exist: the
  /// first of each, in small or capital letters.
  void for_each_row(std::span<const std::string_view> names, const CsvRowUse& use) const;
};

/// A file, read in one pass. Columns are separated by commas, semicolons, tabs or spaces, and cells
/// may stand in quotation marks. A byte-order mark, empty lines and lines that begin with # are
/// skipped; nan and inf are numbers, and numbers beyond the range of double are infinite or zero.
/// All functions throw Error naming the file, the line, the column where it has a name, and the
/// remedy.
class CsvFile {
 public:
  CsvFile(std::filesystem::path path, CsvKind kind);

  /// The first row if none of its cells is a number; otherwise empty.
  const std::vector<std::string>& names() const { return names_; }

  /// Calls `use` for every row of numbers; a first row of words is skipped. Throws Error if a row
  /// has a word in it, and the errors of `use`.
  void read(const CsvRowUse& use);

  /// All rows below that of the names. Columns whose first cell is a word are left out; empty cells
  /// are NaN. Throws Error if there are no names or no numbers, for words in columns of numbers,
  /// and for rows with more or fewer cells than names.
  CsvTable read_table();

 private:
  /// The next row that is not empty; false after the last.
  bool next_row();
  [[noreturn]] void refuse_row() const;
  [[noreturn]] void refuse_cell(std::size_t column) const;

  std::filesystem::path path_;
  CsvKind kind_;
  InputLines in_;
  std::string line_;
  std::string_view row_;  ///< of `line_`
  std::size_t number_ = 0;
  bool first_ = false;  ///< `row_` is the first row, and has not been used
  std::vector<std::string> names_;
  std::vector<std::string_view> cells_;  ///< of `row_`
};

}  // namespace brindle
