#include <algorithm>
#include <array>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "brindle/base/printable.h"
#include "brindle/base/ranges.h"
#include "brindle/error.h"
#include "brindle/files/mesh_formats.h"
#include "brindle/files/read_arrays.h"
#include "brindle/files/text/csv_file.h"
#include "brindle/files/text/text_words.h"

namespace brindle {
namespace {

namespace fs = std::filesystem;

using Names = std::array<std::string_view, 3>;

/// Names of the columns of positions and of normals.
constexpr std::array<Names, 3> kPositions = {
    {{"Points:0", "Points:1", "Points:2"}, {"Points_0", "Points_1", "Points_2"}, {"x", "y", "z"}}};
constexpr std::array<Names, 3> kNormals = {{{"Normals:0", "Normals:1", "Normals:2"},
                                            {"Normals_0", "Normals_1", "Normals_2"},
                                            {"nx", "ny", "nz"}}};

/// The first of these threes that are all there; or none.
const Names* names_among(std::span<const Names> known, std::span<const std::string> names) {
  for (const Names& three : known) {
    const bool all = ranges::all_of(three, [&](std::string_view wanted) {
      return ranges::any_of(names, [&](auto& name) { return same_letters(name, wanted); });
    });
    if (all) return &three;
  }
  return nullptr;
}

/// Whether names find the columns: not if the columns are just those of files without names.
bool has_named_points(const std::vector<std::string>& names) {
  const Names* positions = names_among(kPositions, names);
  if (positions == nullptr) return false;
  const bool has_normals = names.size() == 6 && names_among(kNormals, names) != nullptr;
  const bool plain = (names.size() == 3 || has_normals) && same_letters(names[0], "x") &&
                     same_letters(names[1], "y") && same_letters(names[2], "z");
  return !plain;
}

/// Three columns as vectors.
std::vector<Eigen::Vector3d> vectors_in(const CsvTable& table, const Names& names) {
  std::vector<Eigen::Vector3d> vectors(table.lines.size());
  for (int axis = 0; axis < 3; ++axis) {
    const std::vector<double> numbers = table.numbers_of(names[static_cast<std::size_t>(axis)]);
    for (std::size_t row = 0; row < numbers.size(); ++row) vectors[row][axis] = numbers[row];
  }
  return vectors;
}

/// Points of a file whose first row names their columns; the others are arrays.
LoadedPoints read_named_points(const fs::path& path, CsvFile& file) {
  CsvTable table = file.read_table();
  std::vector<std::string> names;
  for (const DataArray& column : table.columns) names.push_back(column.name);
  const Names* positions = names_among(kPositions, names);
  if (positions == nullptr)
    throw Error(shown(path.string()) + ": its columns of positions hold words; write numbers");
  std::vector<Vec3> normals;
  if (const Names* three = names_among(kNormals, names)) {
    for (const Eigen::Vector3d& n : vectors_in(table, *three)) normals.push_back(n.cast<float>());
  }
  LoadedPoints loaded = make_placed_point_cloud(vectors_in(table, *positions), std::move(normals));
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
  std::vector<Eigen::Vector3d> positions;
  std::vector<Vec3> normals;
  file.read([&](std::size_t line, std::span<const double> row) {
    if (row.size() != 3 && row.size() != 6) {
      throw Error(at_line(path, line) + std::to_string(row.size()) +
                  " columns; a row must have 3 (x,y,z) or 6 (x,y,z,nx,ny,nz)");
    }
    if (!positions.empty() && (row.size() == 6) == normals.empty()) {
      throw Error(at_line(path, line) + std::to_string(row.size()) +
                  " columns where the rows before have another number; give all the same");
    }
    positions.emplace_back(row[0], row[1], row[2]);
    if (row.size() == 6) {
      normals.push_back(Eigen::Vector3d(row[3], row[4], row[5]).cast<float>());
    }
  });
  return make_placed_point_cloud(positions, std::move(normals));
}

}  // namespace brindle
