#include "brindle/pattern_arrays.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstdint>
#include <limits>
#include <utility>

#include "brindle/base/array_numbers.h"
#include "brindle/base/elementary.h"
#include "brindle/base/standard.h"
#include "brindle/error.h"

namespace brindle {
void add_waves(std::vector<DataArray>& arrays, const WrittenWaves& written, float missing,
               const std::vector<float>& branches) {
  std::vector<float> phases, sines;
  std::vector<std::uint8_t> valid;
  for (std::size_t v = 0; v < written.z.size(); ++v) {
    const bool wave = written.has_wave(v);
    phases.push_back(wave ? elementary::arg(written.z[v]) : missing);
    sines.push_back(wave ? elementary::sin(phases.back()) : missing);
    valid.push_back(wave ? 1 : 0);
  }
  arrays.push_back(make_data_array(written.named("phase"), 1, phases));
  arrays.push_back(make_data_array(written.named("direction"), written.waves.directions));
  arrays.push_back(make_data_array(written.named("frequency"), 1, written.waves.frequencies));
  if (!written.frequencies_wanted.empty()) {
    arrays.push_back(
        make_data_array(written.named("frequency_wanted"), 1, written.frequencies_wanted));
  }
  if (!branches.empty()) {
    arrays.push_back(make_data_array(written.named("branch"), 1, branches));
  }
  arrays.push_back(make_data_array(written.named("sin_phase"), 1, sines));
  arrays.push_back(make_data_array(written.named("valid"), 1, valid));
}

void add_carried_waves(std::vector<DataArray>& arrays, const TexturedMesh& textured,
                       const Mesh& mesh, const StripePattern& pattern, const std::string& suffix,
                       float missing) {
  const auto [waves, z] = carried_waves(textured, pattern.waves, pattern.solution.z);
  std::vector<float> flags =
      carried_values(textured, branches_at_vertices(mesh, pattern.corners), 1);
  // A barycentre counts as a branch only if all corners do.
  for (float& flag : flags) flag = std::floor(flag);
  std::vector<float> wanted;
  if (!pattern.frequencies_wanted.empty()) {
    wanted = carried_values(textured, pattern.frequencies_wanted, 1);
  }
  add_waves(arrays, {waves, wanted, z, suffix}, missing, flags);
}

DataArrays textured_arrays(const TexturedMesh& textured, const Surface& surface,
                           std::span<const NamedPattern> patterns, float missing) {
  DataArrays arrays;
  const std::span<const float> normals(reinterpret_cast<const float*>(surface.normals.data()),
                                       3 * surface.normals.size());
  arrays.points.push_back(make_data_array("normal", 3, carried_values(textured, normals, 3)));
  std::vector<float> coordinates;
  for (const auto& uv : textured.coordinates) {
    coordinates.insert(coordinates.end(), {uv.x(), uv.y()});
  }
  arrays.points.push_back(make_data_array("uv", 2, coordinates));
  for (const auto& [pattern, suffix] : patterns) {
    add_carried_waves(arrays.points, textured, surface.mesh, pattern, suffix, missing);
    // Parts of triangles have other corners than these: there are no phases at corners.
    arrays.cells.push_back(
        rows_of(branches_in_triangles(pattern, "branch" + suffix), textured.triangle_origins));
  }
  return arrays;
}

void add_turn(std::vector<DataArray>& arrays, float turn_deg, std::size_t rows) {
  if (turn_deg == 0) return;
  arrays.push_back(make_data_array(kTurnArray, 1, std::vector<float>(rows, turn_deg)));
}

void add_support(std::vector<DataArray>& arrays, const FieldSupport& support) {
  const auto& [coherence, filled] = support;
  if (!coherence.empty()) arrays.push_back(make_data_array("coherence", 1, coherence));
  if (filled.empty()) return;
  arrays.push_back(
      make_data_array("filled", 1, std::vector<std::uint8_t>(filled.begin(), filled.end())));
}

FieldSupport carried_support(const TexturedMesh& textured, const FieldSupport& support) {
  FieldSupport carried;
  if (!support.coherence.empty()) {
    carried.coherence = carried_values(textured, support.coherence, 1);
  }
  if (support.filled.empty()) return carried;
  carried.filled = carried_values(textured, support.filled, 1);
  for (float& filled : carried.filled) filled = std::ceil(filled);
  return carried;
}

FieldSupport with_barycentres(FieldSupport support, std::span<const Triangle> triangles,
                              std::span<const Index> of_triangles) {
  for (const Index t : of_triangles) {
    const auto& [a, b, c] = triangles[t];
    std::vector<float>&coherence = support.coherence, &filled = support.filled;
    if (!coherence.empty()) {
      coherence.push_back((coherence[a] + coherence[b] + coherence[c]) / 3);
    }
    if (!filled.empty()) filled.push_back(std::max({filled[a], filled[b], filled[c]}));
  }
  return support;
}

DataArrays without_turn(const DataArrays& input) {
  DataArrays result = input;
  std::erase_if(result.points, [](const DataArray& array) { return array.name == kTurnArray; });
  return result;
}

float turn_said_by(std::span<const DataArray> arrays) {
  const DataArray* array = find_array(arrays, kTurnArray);
  if (array == nullptr || array->rows() == 0) return 0;
  const std::vector<double> turns = doubles_of(array->view());
  const bool one = ranges::all_of(turns, [&](double turn) { return turn == turns.front(); });
  if (array->components != 1 || !one || !std::isfinite(turns.front())) {
    throw Error(std::string("the array '") + kTurnArray +
                "' must have the same finite number of degrees in all rows");
  }
  return static_cast<float>(turns.front());
}

bool hold_pattern(std::span<const DataArray> points) {
  return find_array(points, "sin_phase") != nullptr;
}

std::vector<InputArray> arrays_beside(std::span<const std::string> own,
                                      std::span<const DataArray> input, bool replaced) {
  const auto is_own = [&](const std::string& name) { return ranges::find(own, name) != own.end(); };
  std::vector<InputArray> result;
  for (const DataArray& array : input) {
    const bool clashes = is_own(array.name);
    if (clashes && replaced) continue;
    InputArray& kept = result.emplace_back(InputArray{array, ""});
    std::string& name = kept.array.name;
    while (is_own(name) || (name != array.name && find_array(input, name) != nullptr)) {
      name += "_input";
    }
    if (clashes) kept.note = "the input's array '" + array.name + "' is kept as '" + name + "'";
  }
  return result;
}

DataArrays join_arrays(DataArrays own, const DataArrays& input, std::vector<std::string>& notes) {
  const bool replaced = hold_pattern(input.points);
  const auto add = [&](std::vector<DataArray>& to, const std::vector<DataArray>& from) {
    std::vector<std::string> names;
    for (const DataArray& array : to) names.push_back(array.name);
    for (InputArray& input_array : arrays_beside(names, from, replaced)) {
      to.push_back(std::move(input_array.array));
      if (!input_array.note.empty()) notes.push_back(std::move(input_array.note));
    }
  };
  add(own.points, input.points);
  add(own.cells, input.cells);
  return own;
}

DataArray carried_ids(const TexturedMesh& textured, std::span<const std::int64_t> ids) {
  std::vector<std::int64_t> carried;
  for (const auto& [a, b, c] : textured.origins) carried.push_back(a == b ? ids[a] : -1);
  return make_data_array("original_id", 1, carried);
}

std::vector<float> branches_at_vertices(const Mesh& mesh, std::span<const CornerPhases> corners) {
  std::vector<float> flags(mesh.vertex_count());
  for (std::size_t t = 0; t < mesh.triangle_count(); ++t) {
    if (!is_branch(corners[t].kind)) continue;
    for (const Index vertex : mesh.triangles[t]) flags[vertex] = 1;
  }
  return flags;
}

DataArray branches_in_triangles(const StripePattern& pattern, const std::string& name) {
  std::vector<std::uint8_t> flags;
  for (const CornerPhases& corners : pattern.corners)
    flags.push_back(is_branch(corners.kind) ? 1 : 0);
  return make_data_array(name, 1, flags);
}

DataArray broken_in_triangles(const TexturedMesh& textured, const BrokenTiles& broken) {
  std::vector<std::uint8_t> flags;
  for (const Index origin : textured.triangle_origins) flags.push_back(broken.touches(origin));
  return make_data_array("tile_broken", 1, flags);
}

DataArray corner_phases_of(const StripePattern& pattern, const std::string& name) {
  constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
  std::vector<float> phases;
  for (const CornerPhases& corners : pattern.corners) {
    const bool lifted =
        corners.kind == TriangleKind::regular || corners.kind == TriangleKind::branch;
    for (const float phase : corners.phase) phases.push_back(lifted ? phase : kNan);
  }
  return make_data_array(name, 3, phases);
}

}  // namespace brindle
