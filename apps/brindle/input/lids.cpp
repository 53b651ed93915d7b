#include "input/lids.h"

#include <cmath>
#include <numbers>
#include <vector>

#include "brindle/base/array_numbers.h"
#include "brindle/base/file_names.h"
#include "brindle/base/text.h"
#include "brindle/error.h"
#include "brindle/normals.h"
#include "cli/option_values.h"

namespace brindle::tool {
namespace {

constexpr const char* kOption = "--lids";

std::vector<bool> marked(const std::string& file, std::size_t triangles) {
  const std::vector<DataArray> columns = read_csv_arrays(file);
  if (columns.size() != 1 || columns[0].components != 1) {
    throw Error(shown(file) + ": lids are one column of 0 and 1, and it has others");
  }
  const std::vector<double> numbers = doubles_of(columns[0].view());
  if (numbers.size() != triangles) {
    throw Error(shown(file) + ": it has " + std::to_string(numbers.size()) +
                " rows for lids, and the mesh has " + std::to_string(triangles) + " triangles");
  }
  std::vector<bool> lids;
  for (std::size_t t = 0; t < numbers.size(); ++t) {
    if (numbers[t] != 0 && numbers[t] != 1) {
      throw Error(shown(file) + ": lids are 1 and others 0; row " + std::to_string(t + 1) +
                  " is neither");
    }
    lids.push_back(numbers[t] == 1);
  }
  return lids;
}

std::vector<bool> level(const Lids& lids, const Mesh& mesh) {
  const float least = std::cos(*lids.degrees * std::numbers::pi_v<float> / 180);
  std::vector<bool> result;
  for (const Triangle& t : mesh.triangles) {
    result.push_back(std::abs(triangle_normal(mesh, t).stableNormalized().dot(lids.up)) > least);
  }
  return result;
}

}  // namespace

Lids parse_lids(const std::string& option, const std::string& text) {
  if (lower_extension(text) == ".csv") return {std::nullopt, text};
  const auto degrees = number_in<float>(text);
  if (!degrees || !(*degrees > 0 && *degrees < 90)) {
    wrong_usage(option, "degrees above 0 and below 90, or FILE.csv", text);
  }
  return {degrees, ""};
}

void leave_out(const Lids& lids, LoadedMesh& loaded) {
  Mesh& mesh = loaded.mesh;
  const std::vector<bool> out =
      lids.degrees ? level(lids, mesh) : marked(lids.file, mesh.triangle_count());
  std::vector<Index> kept;
  std::vector<Triangle> triangles;
  for (std::size_t t = 0; t < out.size(); ++t) {
    if (out[t]) continue;
    kept.push_back(static_cast<Index>(t));
    triangles.push_back(mesh.triangles[t]);
  }
  if (kept.size() == out.size()) {
    throw Error(std::string(kOption) + ": no face is a lid; take a larger angle or leave it out");
  }
  if (kept.empty())
    throw Error(std::string(kOption) + ": all faces are lids; take a smaller angle");
  mesh.triangles = std::move(triangles);
  loaded.arrays.cells = rows_of(loaded.arrays.cells, kept);
}

}  // namespace brindle::tool
