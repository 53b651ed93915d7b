#include "brindle/files/csv_file.h"

#include <algorithm>
#include <fstream>
#include <string_view>
#include <vector>

#include "brindle/base/printable.h"
#include "brindle/error.h"
#include "brindle/files/input_file.h"

namespace brindle {
namespace {

constexpr std::string_view kSpace = " \t\r";

std::string_view trimmed(std::string_view text) {
  const auto first = text.find_first_not_of(kSpace);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(kSpace) - first + 1);
}

std::string_view unquoted(std::string_view cell) {
  const bool quotes = cell.size() > 1 && cell.front() == '"' && cell.back() == '"';
  return quotes ? trimmed(cell.substr(1, cell.size() - 2)) : cell;
}

/// Cuts a row at its separators: the first of semicolon, comma and tab that it has, or else spaces.
void cut(std::string_view row, std::vector<std::string_view>& cells) {
  cells.clear();
  for (const char separator : {';', ',', '\t'}) {
    if (row.find(separator) == std::string_view::npos) continue;
    for (std::size_t begin = 0; begin <= row.size();) {
      const std::size_t end = std::min(row.find(separator, begin), row.size());
      cells.push_back(unquoted(trimmed(row.substr(begin, end - begin))));
      begin = end + 1;
    }
    return;
  }
  for (auto word = take_word(row); !word.empty(); word = take_word(row)) {
    cells.push_back(unquoted(word));
  }
}

/// Whether all cells are numbers, which `values` then has.
bool parse(const std::vector<std::string_view>& cells, std::vector<double>& values) {
  values.clear();
  for (const std::string_view cell : cells) {
    const auto value = parse_number(cell);
    if (!value) return false;
    values.push_back(*value);
  }
  return true;
}

/// Whether every cell begins as a word does.
bool is_header(const std::vector<std::string_view>& cells) {
  return std::none_of(cells.begin(), cells.end(), [](std::string_view cell) {
    return cell.empty() || cell.find_first_of("0123456789+-.") == 0 || parse_number(cell);
  });
}

/// Whether the row would be one of numbers if it had points for its commas.
bool has_decimal_commas(std::string_view row) {
  if (row.find(',') == std::string_view::npos) return false;
  std::string pointed(row);
  std::replace(pointed.begin(), pointed.end(), ',', '.');
  std::vector<std::string_view> cells;
  std::vector<double> ignored;
  cut(pointed, cells);
  return parse(cells, ignored);
}

[[noreturn]] void refuse(const std::filesystem::path& path, std::size_t line, std::string_view row,
                         const CsvKind& kind) {
  const std::string remedy =
      has_decimal_commas(row) ? "write decimal points instead of decimal commas: " : "write ";
  throw Error(at_line(path, line) + in_quotes(row) + " is not a row of numbers; " + remedy +
              kind.columns);
}

std::ifstream open(const std::filesystem::path& path, const CsvKind& kind) {
  std::error_code ignored;
  if (std::filesystem::is_directory(path, ignored)) {
    throw Error("cannot read " + kind.what + " '" + path.string() +
                "': it is a folder; name a CSV file");
  }
  std::ifstream in(path);
  if (!in) throw Error("cannot open " + kind.what + " '" + path.string() + "'; check the path");
  return in;
}

}  // namespace

std::string at_line(const std::filesystem::path& path, std::size_t line) {
  return "'" + path.string() + "', line " + std::to_string(line) + ": ";
}

void read_csv(const std::filesystem::path& path, const CsvKind& kind,
              const std::function<void(std::size_t line, std::span<const double> values)>& use) {
  std::ifstream in = open(path, kind);
  std::string line;
  std::vector<std::string_view> cells;
  std::vector<double> values;
  bool first_row = true;
  for (std::size_t number = 1; std::getline(in, line); ++number) {
    std::string_view row = line;
    if (number == 1 && row.starts_with(kByteOrderMark)) row.remove_prefix(kByteOrderMark.size());
    row = trimmed(row);
    if (row.empty() || row.front() == '#') continue;
    cut(row, cells);
    if (parse(cells, values)) {
      use(number, values);
    } else if (!first_row || !is_header(cells)) {
      refuse(path, number, row, kind);
    }
    first_row = false;
  }
  if (in.bad()) throw Error("cannot read " + kind.what + " '" + path.string() + "': input error");
}

}  // namespace brindle
