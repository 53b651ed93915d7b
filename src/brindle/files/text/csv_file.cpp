#include "brindle/files/text/csv_file.h"

#include <algorithm>
#include <cstring>
#include <iterator>
#include <set>
#include <utility>

#include "brindle/base/input_file.h"
#include "brindle/base/standard.h"
#include "brindle/base/text.h"
#include "brindle/error.h"
#include "brindle/files.h"
#include "brindle/files/read_arrays.h"
#include "brindle/files/text/text_words.h"

namespace brindle {
namespace {

constexpr std::string_view kSpace = " \t\r";

std::string_view trimmed(std::string_view text) {
  const auto first = text.find_first_not_of(kSpace);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(kSpace) - first + 1);
}

/// The position after the closing quotation mark of a cell that begins at `begin`; npos unless the
/// separator or the row's end follows. `vain` marks did not close a cell before and are skipped:
/// many unclosed marks would take quadratic time.
std::size_t end_of_quoted(std::string_view row, std::size_t begin, char separator,
                          std::set<std::size_t>& vain) {
  std::vector<std::size_t> followed;
  std::size_t mark = row.find('"', begin + 1);
  while (mark != std::string_view::npos && !vain.contains(mark)) {
    followed.push_back(mark);
    if (mark + 1 < row.size() && row[mark + 1] == '"') {
      mark = row.find('"', mark + 2);
      continue;
    }
    const std::size_t next = row.find_first_not_of(separator == '\t' ? " \r" : kSpace, mark + 1);
    if (next == std::string_view::npos || row[next] == separator) return mark + 1;
    mark = row.find('"', mark + 1);
  }
  vain.insert(followed.begin(), followed.end());
  return std::string_view::npos;
}

/// The end of the cell that begins at `begin`: the next separator outside quotation marks.
std::size_t end_of_cell(std::string_view row, std::size_t begin, char separator,
                        std::set<std::size_t>& vain) {
  const std::size_t first = row.find_first_not_of(" \r", begin);
  if (first != std::string_view::npos && row[first] == '"') {
    const std::size_t end = end_of_quoted(row, first, separator, vain);
    if (end != std::string_view::npos) begin = end;
  }
  return std::min(row.find(separator, begin), row.size());
}

std::string_view unquoted(std::string_view cell) {
  const bool quotes = cell.size() > 1 && cell.front() == '"' && cell.back() == '"';
  return quotes ? trimmed(cell.substr(1, cell.size() - 2)) : cell;
}

/// Whether a row has a separator outside quoted cells, whatever separates these.
bool has_separator(std::string_view row, char separator) {
  constexpr std::string_view kSeparators = ";,\t";
  const auto ends_at = [&](std::size_t place) {
    return place == std::string_view::npos ||
           kSeparators.find(row[place]) != std::string_view::npos;
  };
  bool begins = true, closes = true;  // after one unclosed mark, no later one closes
  for (std::size_t i = 0; i < row.size(); ++i) {
    if (row[i] == separator) return true;
    if (row[i] == '"' && begins && closes) {
      std::size_t mark = row.find('"', i + 1);
      while (mark != std::string_view::npos && !ends_at(row.find_first_not_of(" \r", mark + 1))) {
        mark = row.find('"', mark + (row.substr(mark, 2) == "\"\"" ? 2 : 1));
      }
      closes = mark != std::string_view::npos;
      if (closes) i = mark;
    }
    begins = ends_at(i) || (begins && row[i] == ' ');
  }
  return false;
}

/// Splits a row at the first of semicolon, comma and tab that separates cells, or else at spaces.
void cut(std::string_view row, std::vector<std::string_view>& cells) {
  for (const char separator : {';', ',', '\t'}) {
    if (!has_separator(row, separator)) continue;
    cells.clear();
    std::set<std::size_t> vain;
    for (std::size_t begin = 0; begin <= row.size();) {
      const std::size_t end = end_of_cell(row, begin, separator, vain);
      cells.push_back(unquoted(trimmed(row.substr(begin, end - begin))));
      begin = end + 1;
    }
    if (cells.size() > 1) return;
  }
  cells.clear();
  for (auto word = take_word(row); !word.empty(); word = take_word(row)) {
    cells.push_back(unquoted(word));
  }
}

/// Whether all cells are numbers; `values` receives them.
bool parse(const std::vector<std::string_view>& cells, std::vector<double>& values) {
  values.clear();
  for (const std::string_view cell : cells) {
    const auto value = parse_number(cell);
    if (!value) return false;
    values.push_back(*value);
  }
  return true;
}

/// Whether a cell is quoted; the marks are not part of it.
bool is_quoted(std::string_view row, std::string_view cell) {
  const auto begin = static_cast<std::size_t>(cell.data() - row.data()), end = begin + cell.size();
  return begin > 0 && end < row.size() && row[begin - 1] == '"' && row[end] == '"';
}

/// Whether every cell starts like a word or is quoted.
bool is_header(std::string_view row, const std::vector<std::string_view>& cells) {
  return std::none_of(cells.begin(), cells.end(), [&](std::string_view cell) {
    const bool is_number = cell.find_first_of("0123456789+-.") == 0 || parse_number(cell);
    return cell.empty() || (is_number && !is_quoted(row, cell));
  });
}

/// Whether cells are names: words, among which numbers are quoted.
bool are_names(std::string_view row, const std::vector<std::string_view>& cells) {
  bool has_words = false;
  for (const std::string_view cell : cells) {
    if (!parse_number(cell)) {
      has_words = true;
    } else if (!is_quoted(row, cell)) {
      return false;
    }
  }
  return has_words;
}

/// Whether the row would be numeric with decimal points for its commas.
bool has_decimal_commas(std::string_view row) {
  if (row.find(',') == std::string_view::npos) return false;
  std::string pointed(row);
  std::replace(pointed.begin(), pointed.end(), ',', '.');
  std::vector<std::string_view> cells;
  std::vector<double> ignored;
  cut(pointed, cells);
  return parse(cells, ignored);
}

/// A name with doubled quotation marks reduced to one.
std::string name_in(std::string_view cell) {
  std::string name;
  for (std::size_t i = 0; i < cell.size(); ++i) {
    name += cell[i];
    if (cell.substr(i, 2) == "\"\"") ++i;
  }
  return name;
}

}  // namespace

std::string at_line(const std::filesystem::path& path, std::size_t line) {
  return "'" + shown(path.string()) + "', line " + std::to_string(line) + ": ";
}

bool has_column(std::span<const std::string> names, std::string_view name) {
  return ranges::any_of(names, [&](auto& other) { return same_letters(other, name); });
}

std::vector<std::string> CsvTable::names() const {
  std::vector<std::string> result;
  for (const DataArray& column : columns) result.push_back(column.name);
  return result;
}

void CsvTable::for_each_row(std::span<const std::string_view> names, const CsvRowUse& use) const {
  std::vector<const std::byte*> numbers;
  for (const std::string_view name : names) {
    const auto column = ranges::find_if(
        columns, [&](const DataArray& one) { return same_letters(one.name, name); });
    numbers.push_back(column->bytes.data());
  }
  std::vector<double> values(names.size());
  for (std::size_t row = 0; row < lines.size(); ++row) {
    for (std::size_t i = 0; i < values.size(); ++i) {
      std::memcpy(&values[i], numbers[i] + row * sizeof(double), sizeof(double));
    }
    use(lines[row], values);
  }
}

CsvFile::CsvFile(std::filesystem::path path, CsvKind kind)
    : path_(std::move(path)), kind_(std::move(kind)), in_(open_input(path_, "a CSV file")) {
  first_ = next_row();
  if (first_ && are_names(row_, cells_))
    ranges::transform(cells_, std::back_inserter(names_), name_in);
}

bool CsvFile::next_row() {
  while (in_.next(line_)) {
    row_ = line_;
    if (++number_ == 1 && row_.starts_with(kByteOrderMark)) {
      row_.remove_prefix(kByteOrderMark.size());
    }
    row_ = trimmed(row_);
    if (row_.empty() || row_.front() == '#') continue;
    cut(row_, cells_);
    return true;
  }
  if (in_.bad())
    throw Error("cannot read " + kind_.what + " '" + shown(path_.string()) + "': input error");
  return false;
}

void CsvFile::refuse_row() const {
  const std::string remedy =
      has_decimal_commas(row_) ? "write decimal points instead of decimal commas: " : "write ";
  const bool may_be_names = first_ && ranges::any_of(cells_, [](std::string_view cell) {
                              return !cell.empty() && !parse_number(cell);
                            });
  throw Error(at_line(path_, number_) + in_quotes(row_) + " is not a row of numbers; " + remedy +
              kind_.columns +
              (may_be_names
                   ? ", or put names of columns that look like numbers between quotation marks"
                   : ""));
}

void CsvFile::refuse_cell(std::size_t column) const {
  const std::string_view cell = cells_[column];
  const bool commas = cell.find(',') != std::string_view::npos;
  throw Error(at_line(path_, number_) + "column " + in_quotes(names_[column]) + " has " +
              in_quotes(cell) + ", which is not a number; " +
              (commas ? "write decimal points, and nothing between thousands"
                      : "write a number, or nothing where there is none"));
}

void CsvFile::read(const CsvRowUse& use) {
  std::vector<double> values;
  for (bool more = first_; more; more = next_row()) {
    if (parse(cells_, values)) {
      use(number_, values);
    } else if (!first_ || !is_header(row_, cells_)) {
      refuse_row();
    }
    first_ = false;
  }
}

CsvTable CsvFile::read_table() {
  if (names_.empty()) {
    std::vector<double> numbers;
    if (first_ && !parse(cells_, numbers)) refuse_row();
    throw Error("'" + shown(path_.string()) +
                "' does not name its columns; write their names into its first row");
  }
  std::vector<std::vector<double>> columns(names_.size());
  std::vector<char> of_words(names_.size(), 0);
  CsvTable table;
  while (next_row()) {
    if (cells_.size() != names_.size()) {
      throw Error(at_line(path_, number_) + std::to_string(cells_.size()) +
                  " cells where the first row names " + std::to_string(names_.size()) +
                  " columns; give every row one for each");
    }
    for (std::size_t c = 0; c < cells_.size(); ++c) {
      if (of_words[c]) continue;
      const auto number = cells_[c].empty() ? std::optional(std::nan("")) : parse_double(cells_[c]);
      if (number) {
        columns[c].push_back(*number);
      } else if (table.lines.empty()) {
        of_words[c] = 1;
      } else {
        refuse_cell(c);
      }
    }
    table.lines.push_back(number_);
  }
  for (std::size_t c = 0; c < columns.size(); ++c) {
    if (!of_words[c]) table.columns.push_back(make_data_array(names_[c], 1, columns[c]));
  }
  if (table.lines.empty() || table.columns.empty()) {
    throw Error("'" + shown(path_.string()) +
                "' has no numbers below its names of columns; export it "
                "again");
  }
  return table;
}

std::vector<DataArray> csv_columns(const std::filesystem::path& path) {
  const CsvFile file(path, {"field", "x,y,z or x,y,z,frequency"});
  std::vector<DataArray> columns;
  for (const std::string& name : file.names()) {
    const std::vector<double> place = {static_cast<double>(columns.size())};
    columns.push_back(make_data_array(name, 1, place));
  }
  return grouped_columns(std::move(columns));
}

std::vector<DataArray> read_csv_arrays(const std::filesystem::path& path) {
  CsvFile file(path, {"arrays", "a row of names and rows of numbers"});
  std::vector<DataArray> arrays = grouped_columns(file.read_table().columns);
  make_names_unique(arrays);
  return arrays;
}

}  // namespace brindle
