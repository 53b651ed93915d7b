#include <algorithm>
#include <array>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "brindle/base/standard.h"
#include "brindle/base/text.h"
#include "brindle/error.h"
#include "brindle/files/mesh_formats.h"
#include "brindle/files/read_arrays.h"
#include "brindle/files/text/csv_file.h"
#include "brindle/files/text/text_words.h"

namespace brindle {
namespace {

namespace fs = std::filesystem;

using Names = std::array<std::string_view, 3>;

/// Names of position and normal columns.
constexpr std::array<Names, 3> kPositions = {
    {{"Points:0", "Points:1", "Points:2"}, {"Points_0", "Points_1", "Points_2"}, {"x", "y", "z"}}};
constexpr std::array<Names, 5> kNormals = {{{"Normals:0", "Normals:1", "Normals:2"},
                                            {"Normals_0", "Normals_1", "Normals_2"},
                                            kNormalNames[0],
                                            kNormalNames[1],
                                            kNormalNames[2]}};

/// The first of these triples that is complete, or null.
const Names* names_among(std::span<const Names> known, std::span<const std::string> names) {
  for (const Names& three : known) {
    if (ranges::all_of(three, [&](auto name) { return has_column(names, name); })) return &three;
  }
  return nullptr;
}

/// Whether columns are found by name: not if they are just the positional ones.
bool has_named_points(const std::vector<std::string>& names) {
  const Names* positions = names_among(kPositions, names);
  if (positions == nullptr) return false;
  const bool has_normals = names.size() == 6 && names_among(kNormals, names) != nullptr;
  const bool plain = (names.size() == 3 || has_normals) && same_letters(names[0], "x") &&
                     same_letters(names[1], "y") && same_letters(names[2], "z");
  return !plain;
}

struct PointRows {
  std::vector<Eigen::Vector3d> positions;
  std::vector<Vec3> normals;

  /// x,y,z or x,y,z,nx,ny,nz.
  void add(std::span<const double> row) {
    positions.emplace_back(row[0], row[1], row[2]);
    if (row.size() < 6) return;
    normals.push_back(Eigen::Vector3d(row[3], row[4], row[5]).cast<float>());
  }
};

/// Points of a file with named columns; other columns become arrays.
LoadedPoints read_named_points(const fs::path& path, CsvFile& file) {
  CsvTable table = file.read_table();
  const std::vector<std::string> names = table.names();
  const Names* positions = names_among(kPositions, names);
  if (positions == nullptr)
    throw Error(shown(path.string()) + ": its columns of positions hold words; write numbers");
  std::vector<std::string_view> columns(positions->begin(), positions->end());
  if (const Names* normals = names_among(kNormals, names)) {
    columns.insert(columns.end(), normals->begin(), normals->end());
  }
  PointRows rows;
  table.for_each_row(columns, [&](std::size_t, std::span<const double> row) { rows.add(row); });
  LoadedPoints loaded = make_placed_point_cloud(rows.positions, std::move(rows.normals));
  std::erase_if(table.columns, [&](const DataArray& column) {
    return ranges::any_of(*positions, [&](auto name) { return same_letters(column.name, name); });
  });
  loaded.arrays = grouped_columns(std::move(table.columns));
  make_names_unique(loaded.arrays);
  return loaded;
}

}  // namespace

LoadedPoints read_csv_points(const fs::path& path) {
  CsvFile file(path, {"points", "x,y,z or x,y,z,nx,ny,nz"});
  if (has_named_points(file.names())) return read_named_points(path, file);
  PointRows rows;
  file.read([&](std::size_t line, std::span<const double> row) {
    if (row.size() != 3 && row.size() != 6) {
      throw Error(at_line(path, line) + std::to_string(row.size()) +
                  " columns; a row must have 3 (x,y,z) or 6 (x,y,z,nx,ny,nz)");
    }
    if (!rows.positions.empty() && (row.size() == 6) == rows.normals.empty()) {
      throw Error(at_line(path, line) + std::to_string(row.size()) +
                  " columns where the rows before have another number; give all the same");
    }
    rows.add(row);
  });
  return make_placed_point_cloud(rows.positions, std::move(rows.normals));
}

}  // namespace brindle
