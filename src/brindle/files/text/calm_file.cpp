#include <algorithm>
#include <string>

#include "brindle/base/text.h"
#include "brindle/error.h"
#include "brindle/files.h"
#include "brindle/files/text/csv_file.h"

namespace brindle {
namespace {

void refuse_rows(const std::filesystem::path& path, std::size_t rows, std::size_t line,
                 std::size_t vertex_count, std::size_t file_vertices) {
  std::string count = std::to_string(vertex_count);
  if (file_vertices > vertex_count)
    count += ", or " + std::to_string(file_vertices) + " in its file,";
  const std::string has = rows == 0 ? std::string("has no rows")
                                    : "ends at line " + std::to_string(line) + " after " +
                                          std::to_string(rows) + " rows";
  throw Error("'" + shown(path.string()) + "' " + has + ", but the mesh has " + count +
              " vertices; give one row per vertex");
}

float checked_calm(const std::filesystem::path& path, std::size_t line, double value) {
  if (value >= 0 && value <= 1) return static_cast<float>(value);
  throw Error(at_line(path, line) + formatted("calm is %g; give a number from 0 to 1", value));
}

// Rows and the line of each.
struct CalmRows {
  std::vector<float> calm;
  std::size_t last_line = 0;
};

CalmRows read_rows(const std::filesystem::path& path) {
  CalmRows rows;
  const auto add = [&](std::size_t line, double value) {
    rows.calm.push_back(checked_calm(path, line, value));
    rows.last_line = line;
  };
  CsvFile file(path, {"calm", "one number from 0 to 1"});
  if (file.names().size() > 1) {
    const CsvTable table = file.read_table();
    const std::vector<double> values = table.numbers_of("calm");
    if (values.empty()) {
      throw Error("'" + shown(path.string()) +
                  "' has no column of numbers named calm; name one so");
    }
    for (std::size_t row = 0; row < values.size(); ++row) add(table.lines[row], values[row]);
    return rows;
  }
  file.read([&](std::size_t line, std::span<const double> values) {
    if (values.size() != 1) {
      throw Error(at_line(path, line) + std::to_string(values.size()) +
                  " columns; give one number from 0 to 1 a row, or name a column calm");
    }
    add(line, values[0]);
  });
  return rows;
}

}  // namespace

std::vector<float> read_calm_csv(const std::filesystem::path& path, std::size_t vertex_count,
                                 std::span<const Index> vertex_of_row) {
  CalmRows rows = read_rows(path);
  if (rows.calm.size() == vertex_count) return std::move(rows.calm);
  if (vertex_of_row.empty() || rows.calm.size() != vertex_of_row.size()) {
    refuse_rows(path, rows.calm.size(), rows.last_line, vertex_count, vertex_of_row.size());
  }
  std::vector<float> calm(vertex_count);
  for (std::size_t row = 0; row < rows.calm.size(); ++row) {
    float& greatest = calm[vertex_of_row[row]];
    greatest = std::max(greatest, rows.calm[row]);
  }
  return calm;
}

}  // namespace brindle
