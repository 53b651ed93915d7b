#include "brindle/files/csv_file.h"

#include <charconv>
#include <fstream>
#include <string_view>
#include <vector>

#include "brindle/error.h"

namespace brindle {
namespace {

std::string_view trimmed(std::string_view text) {
  const auto first = text.find_first_not_of(" \t\r");
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t\r") - first + 1);
}

/// Whether all cells of the row are numbers, which `values` then has.
bool parse_row(std::string_view row, std::vector<float>& values) {
  values.clear();
  while (true) {
    const auto comma = row.find(',');
    std::string_view cell = trimmed(row.substr(0, comma));
    if (cell.starts_with('+')) cell.remove_prefix(1);
    float value = 0;
    const auto [end, failure] = std::from_chars(cell.data(), cell.data() + cell.size(), value);
    if (failure != std::errc() || end != cell.data() + cell.size()) return false;
    values.push_back(value);
    if (comma == std::string_view::npos) return true;
    row.remove_prefix(comma + 1);
  }
}

}  // namespace

std::string at_line(const std::filesystem::path& path, std::size_t line) {
  return "'" + path.string() + "', line " + std::to_string(line) + ": ";
}

void read_csv(const std::filesystem::path& path, const CsvKind& kind,
              const std::function<void(std::size_t line, std::span<const float> values)>& use) {
  std::error_code ignored;
  if (std::filesystem::is_directory(path, ignored)) {
    throw Error("cannot read " + kind.what + " '" + path.string() +
                "': it is a folder; name a CSV file");
  }
  std::ifstream in(path);
  if (!in) throw Error("cannot open " + kind.what + " '" + path.string() + "'; check the path");
  std::string line;
  std::vector<float> values;
  for (std::size_t number = 1; std::getline(in, line); ++number) {
    const std::string_view row = trimmed(line);
    if (row.empty() || row.front() == '#') continue;
    if (parse_row(row, values)) {
      use(number, values);
    } else if (number > 1 || row.find_first_of("0123456789") != std::string_view::npos) {
      throw Error(at_line(path, number) + "'" + std::string(row.substr(0, 60)) +
                  "' is not a row of numbers; write " + kind.columns);
    }
  }
}

}  // namespace brindle
