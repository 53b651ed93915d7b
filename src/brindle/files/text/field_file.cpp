#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <Eigen/Geometry>

#include "brindle/base/axis_mean.h"
#include "brindle/base/standard.h"
#include "brindle/base/text.h"
#include "brindle/error.h"
#include "brindle/files.h"
#include "brindle/files/text/csv_file.h"
#include "brindle/files/text/text_words.h"

namespace brindle {
namespace {

void append_row(FieldFile& field, std::span<const double> row, const std::string& where) {
  if (row.size() < 3 || row.size() > 5) {
    throw Error(where + std::to_string(row.size()) +
                " columns; a row must have 3 (x,y,z), 4 (x,y,z,frequency) or 5 "
                "(x,y,z,frequency,frequency_v)");
  }
  const std::size_t columns =
      3 + (field.frequencies.empty() ? 0 : 1) + (field.frequencies_v.empty() ? 0 : 1);
  if (!field.vectors.empty() && row.size() != columns) {
    throw Error(where + std::to_string(row.size()) + " columns where the rows before have " +
                std::to_string(columns) + "; give all rows the same number");
  }
  for (std::size_t column = 3; column < row.size(); ++column) {
    const auto frequency = static_cast<float>(row[column]);
    if (!(frequency > 0) || !std::isfinite(frequency)) {
      throw Error(where + "the frequency must be a finite number above zero");
    }
  }
  field.vectors.push_back(float_vector({row[0], row[1], row[2]}));
  if (row.size() > 3) field.frequencies.push_back(static_cast<float>(row[3]));
  if (row.size() > 4) field.frequencies_v.push_back(static_cast<float>(row[4]));
}

/// Calls `use` for each row of a field with named columns: x, y, z and frequencies.
void read_named_field(const std::filesystem::path& path, CsvFile& file, const CsvRowUse& use) {
  const CsvTable table = file.read_table();
  const std::vector<std::string> of_numbers = table.names();
  std::vector<std::string_view> columns;
  for (const char* name : {"x", "y", "z", "frequency", "frequency_v"}) {
    if (!has_column(file.names(), name)) break;
    columns.push_back(name);
    if (has_column(of_numbers, name)) continue;
    throw Error("'" + shown(path.string()) + "': column '" + name +
                "' does not begin with a number; write numbers below its name");
  }
  table.for_each_row(columns, use);
}

/// Whether columns are identified by name instead of position.
bool has_named_columns(const std::vector<std::string>& names) {
  if (!has_column(names, "x") || !has_column(names, "y") || !has_column(names, "z")) return false;
  const bool first =
      same_letters(names[0], "x") && same_letters(names[1], "y") && same_letters(names[2], "z");
  return !first || names.size() > 5 || has_column(names, "frequency") ||
         has_column(names, "frequency_v");
}

std::vector<float> means(std::span<const float> rows, std::size_t vertex_count,
                         std::span<const Index> vertex_of_row) {
  if (rows.empty()) return {};
  std::vector<double> sums(vertex_count, 0), counts(vertex_count, 0);
  for (std::size_t row = 0; row < rows.size(); ++row) {
    sums[vertex_of_row[row]] += rows[row];
    ++counts[vertex_of_row[row]];
  }
  std::vector<float> result;
  for (std::size_t v = 0; v < vertex_count; ++v) {
    result.push_back(static_cast<float>(sums[v] / counts[v]));
  }
  return result;
}

/// Of axes with weight 1; zero if there are none.
Vec3 mean_of(std::span<const WeightedAxis> axes) {
  if (const auto turned = mean_of_turned(axes)) return turned->cast<float>();
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const WeightedAxis& one : axes) sum += one.axis / static_cast<double>(axes.size());
  return sum.cast<float>();
}

/// The field of a mesh's vertices from the rows of its file.
FieldFile of_vertices(const FieldFile& rows, std::size_t vertex_count,
                      std::span<const Index> vertex_of_row) {
  std::vector<std::vector<WeightedAxis>> gathered(vertex_count);
  for (std::size_t row = 0; row < rows.vectors.size(); ++row) {
    const Vec3& vector = rows.vectors[row];
    const bool has_direction = vector.allFinite() && !vector.isZero(0);
    if (has_direction) gathered[vertex_of_row[row]].push_back({vector.cast<double>(), 1});
  }
  FieldFile field;
  for (const auto& axes : gathered) field.vectors.push_back(mean_of(axes));
  field.frequencies = means(rows.frequencies, vertex_count, vertex_of_row);
  field.frequencies_v = means(rows.frequencies_v, vertex_count, vertex_of_row);
  return field;
}

/// "83", or "83, or 240 with those at one place".
std::string counts(std::size_t vertices, std::size_t rows) {
  std::string text = std::to_string(vertices);
  if (rows > vertices) text += ", or " + std::to_string(rows) + " in its file";
  return text;
}

[[noreturn]] void refuse_penalty_rows(const std::filesystem::path& path, std::size_t rows,
                                      std::size_t line, std::size_t vertex_count,
                                      std::size_t file_vertices) {
  std::string count = std::to_string(vertex_count);
  if (file_vertices > vertex_count)
    count += ", or " + std::to_string(file_vertices) + " in its file,";
  const std::string has = rows == 0 ? std::string("has no rows")
                                    : "ends at line " + std::to_string(line) + " after " +
                                          std::to_string(rows) + " rows";
  throw Error("'" + shown(path.string()) + "' " + has + ", but the mesh has " + count +
              " vertices; give one row per vertex");
}

float checked_penalty(const std::filesystem::path& path, std::size_t line, double value) {
  if (value >= 0 && value <= 1) return static_cast<float>(value);
  throw Error(at_line(path, line) +
              formatted("avoid_branches is %g; give a number from 0 to 1", value));
}

struct PenaltyRows {
  std::vector<float> branch_penalty;
  std::size_t last_line = 0;  ///< line of the last row
};

PenaltyRows read_penalty_rows(const std::filesystem::path& path) {
  PenaltyRows rows;
  const auto add = [&](std::size_t line, double value) {
    rows.branch_penalty.push_back(checked_penalty(path, line, value));
    rows.last_line = line;
  };
  CsvFile file(path, {"avoid_branches", "one number from 0 to 1"});
  if (file.names().size() > 1) {
    const CsvTable table = file.read_table();
    if (!has_column(table.names(), "avoid_branches")) {
      throw Error("'" + shown(path.string()) +
                  "' has no column of numbers named avoid_branches; name one so");
    }
    table.for_each_row(
        std::array<std::string_view, 1>{"avoid_branches"},
        [&](std::size_t line, std::span<const double> values) { add(line, values[0]); });
    return rows;
  }
  file.read([&](std::size_t line, std::span<const double> values) {
    if (values.size() != 1) {
      throw Error(at_line(path, line) + std::to_string(values.size()) +
                  " columns; give one number from 0 to 1 a row, or name a column avoid_branches");
    }
    add(line, values[0]);
  });
  return rows;
}

}  // namespace

FieldFile read_field_csv(const std::filesystem::path& path, std::size_t vertex_count,
                         std::span<const Index> vertex_of_row) {
  const std::size_t most = std::max(vertex_count, vertex_of_row.size());
  FieldFile field;
  const auto append = [&](std::size_t line, std::span<const double> row) {
    if (field.vectors.size() == most) {
      throw Error(at_line(path, line) + "more rows than the mesh has vertices (" +
                  counts(vertex_count, vertex_of_row.size()) + "); give one row per vertex");
    }
    append_row(field, row, at_line(path, line));
  };
  CsvFile file(path, {"field", "x,y,z or x,y,z,frequency"});
  if (has_named_columns(file.names())) {
    read_named_field(path, file, append);
  } else {
    file.read(append);
  }
  if (field.vectors.size() == vertex_count) return field;
  if (!vertex_of_row.empty() && field.vectors.size() == vertex_of_row.size()) {
    return of_vertices(field, vertex_count, vertex_of_row);
  }
  throw Error("'" + shown(path.string()) + "' has " + std::to_string(field.vectors.size()) +
              " rows, but the mesh has " + counts(vertex_count, vertex_of_row.size()) +
              " vertices; give one row per vertex");
}

std::vector<float> read_branch_penalty_csv(const std::filesystem::path& path,
                                           std::size_t vertex_count,
                                           std::span<const Index> vertex_of_row) {
  PenaltyRows rows = read_penalty_rows(path);
  if (rows.branch_penalty.size() == vertex_count) return std::move(rows.branch_penalty);
  if (vertex_of_row.empty() || rows.branch_penalty.size() != vertex_of_row.size()) {
    refuse_penalty_rows(path, rows.branch_penalty.size(), rows.last_line, vertex_count,
                        vertex_of_row.size());
  }
  std::vector<float> branch_penalty(vertex_count);
  for (std::size_t row = 0; row < rows.branch_penalty.size(); ++row) {
    float& greatest = branch_penalty[vertex_of_row[row]];
    greatest = std::max(greatest, rows.branch_penalty[row]);
  }
  return branch_penalty;
}

}  // namespace brindle
