/// Files of numbers in rows and columns.
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <span>
#include <string>

namespace brindle {

/// What a file is, for messages: "field", "x,y,z or x,y,z,frequency".
struct CsvKind {
  std::string what;
  std::string columns;
};

/// Where a row stands, as messages begin: "'path', line 7: ".
std::string at_line(const std::filesystem::path& path, std::size_t line);

/// Calls `use(line, values)` for every row of numbers, `line` counted from 1. Columns are separated
/// by commas, semicolons, tabs or spaces, and cells may stand in quotation marks. A byte-order
/// mark, a first row of words, empty lines and lines that begin with # are skipped; nan and inf are
/// numbers, and numbers beyond the range of double are infinite or zero. Throws Error naming the
/// file, the line and the remedy if the file cannot be read or a row has a word in it, and whatever
/// `use` throws.
void read_csv(const std::filesystem::path& path, const CsvKind& kind,
              const std::function<void(std::size_t line, std::span<const double> values)>& use);

}  // namespace brindle
