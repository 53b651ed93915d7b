#include "input/carried_pattern.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <unordered_map>
#include <utility>

#include "brindle/base/array_numbers.h"
#include "brindle/base/elementary.h"
#include "brindle/base/text.h"
#include "brindle/error.h"
#include "brindle/files.h"
#include "brindle/normals.h"
#include "brindle/pattern_arrays.h"
#include "brindle/points.h"
#include "cli/option_values.h"
#include "input/surface_options.h"

namespace brindle::tool {
namespace {

constexpr std::string_view kIdPrefix = "id:";

MatchOptions parse_match(const std::string& option, const std::string& text) {
  if (text == "number") return {Matching::number, ""};
  if (text == "position") return {Matching::position, ""};
  if (text.starts_with(kIdPrefix) && text.size() > kIdPrefix.size()) {
    return {Matching::id, text.substr(kIdPrefix.size())};
  }
  wrong_usage(option, "number, position or id:NAME", text);
}

/// The array with `components` numbers in a row, as doubles.
std::vector<double> numbers_of(const KeptPattern& pattern, const std::string& name,
                               int components) {
  const DataArray* array = find_array(pattern.arrays, name);
  if (array != nullptr && array->components == components &&
      array->rows() == pattern.mesh.vertex_count()) {
    return doubles_of(array->view());
  }
  throw Error(pattern.name + ": there is no point array '" + name + "' with " +
              std::to_string(components) + (components == 1 ? " component" : " components") +
              "; name a file that brindle has written with 'phase', 'direction' and 'frequency'");
}

bool is_frequency(double number) {
  return number > 0 && number <= static_cast<double>(std::numeric_limits<float>::max());
}

void set_waves(KeptPattern& pattern) {
  const std::vector<double> phases = numbers_of(pattern, "phase", 1);
  const std::vector<double> directions = numbers_of(pattern, "direction", 3);
  const std::vector<double> frequencies = numbers_of(pattern, "frequency", 1);
  const std::size_t count = phases.size();
  pattern.waves = {pattern.mesh.positions, std::vector<Vec3>(count, Vec3::Zero()),
                   std::vector<float>(count, 1.0f)};
  pattern.z.resize(count);
  for (std::size_t i = 0; i < count; ++i) {
    const Eigen::Vector3d direction(directions[3 * i], directions[3 * i + 1],
                                    directions[3 * i + 2]);
    const double length = direction.norm();
    if (!std::isfinite(phases[i]) || !(length > 0) || !std::isfinite(length) ||
        !is_frequency(frequencies[i])) {
      continue;
    }
    pattern.waves.directions[i] = (direction / length).cast<float>();
    pattern.waves.frequencies[i] = static_cast<float>(frequencies[i]);
    pattern.z[i] = elementary::polar(1.0f, static_cast<float>(phases[i]));
  }
}

void set_turn(KeptPattern& pattern) {
  try {
    pattern.turn_deg = turn_said_by(pattern.arrays);
  } catch (const Error& error) {
    throw Error(pattern.name + ": " + error.what());
  }
}

/// An id per vertex; empty for negative ids.
std::vector<std::optional<std::int64_t>> ids_of(const std::string& file,
                                                std::span<const DataArray> arrays,
                                                const std::string& name, std::size_t vertices) {
  const DataArray* array = find_array(arrays, name);
  if (array == nullptr || array->components != 1 || array->rows() != vertices) {
    throw Error(file + ": there is no point array '" + name + "' with 1 component to match by");
  }
  std::vector<std::optional<std::int64_t>> ids(vertices);
  for_each_number(array->view(), [&](std::size_t row, std::size_t, auto number) {
    if constexpr (std::is_floating_point_v<decltype(number)>) {
      // The largest integer up to which all are exact doubles.
      constexpr double kLargest = 9007199254740992.0;
      const auto value = static_cast<double>(number);
      if (!(std::abs(value) <= kLargest) || value != std::floor(value)) {
        throw Error(file + ": row " + std::to_string(row) + " of array '" + name +
                    "' is no whole number; ids must be");
      }
    }
    const auto id = static_cast<std::int64_t>(number);
    if (id >= 0) ids[row] = id;
  });
  return ids;
}

std::vector<Index> counterparts_by_id(const MatchSide& last, const MatchSide& follower,
                                      const std::string& array) {
  const auto last_ids = ids_of(last.name, last.arrays, array, last.mesh.vertex_count());
  std::unordered_map<std::int64_t, Index> vertex_of;
  for (Index v = 0; v < last_ids.size(); ++v) {
    if (!last_ids[v]) continue;
    const auto [known, is_new] = vertex_of.emplace(*last_ids[v], v);
    if (!is_new) {
      throw Error(last.name + ": vertices " + std::to_string(known->second) + " and " +
                  std::to_string(v) + " both have " + std::to_string(*last_ids[v]) + " in array '" +
                  array + "'; ids must differ");
    }
  }
  std::vector<Index> counterparts;
  for (const auto& id :
       ids_of(follower.name, follower.arrays, array, follower.mesh.vertex_count())) {
    const auto found = id ? vertex_of.find(*id) : vertex_of.end();
    counterparts.push_back(found == vertex_of.end() ? kNoCounterpart : found->second);
  }
  return counterparts;
}

void check_numbers(const MatchSide& last, const MatchSide& follower) {
  if (last.mesh.vertex_count() == follower.mesh.vertex_count()) return;
  throw Error(follower.name + ": has " + std::to_string(follower.mesh.vertex_count()) +
              " vertices and " + last.name + " " + std::to_string(last.mesh.vertex_count()) +
              ", which cannot be matched by number; take --match position or id:NAME");
}

}  // namespace

std::string_view name_of(Matching matching) {
  switch (matching) {
    case Matching::number:
      return "number";
    case Matching::id:
      return "id";
    case Matching::position:
      break;
  }
  return "position";
}

CLI::Option* add_match_option(CLI::App& app, MatchOptions& options) {
  return add_parsed_option(app, "--match", options, parse_match);
}

KeptPattern read_pattern(const std::filesystem::path& path) {
  KeptPattern pattern;
  pattern.name = path.string();
  SurfaceFile file(path);
  if (!file.has_faces()) {
    LoadedPoints loaded = file.points();
    pattern.mesh.positions = std::move(loaded.cloud.positions);
    pattern.mesh.origin = loaded.cloud.origin;
    pattern.normals = std::move(loaded.cloud.normals);
    pattern.arrays = std::move(loaded.arrays);
  } else {
    LoadedMesh loaded = file.mesh();
    pattern.mesh = std::move(loaded.mesh);
    pattern.arrays = std::move(loaded.arrays.points);
  }
  set_waves(pattern);
  set_turn(pattern);
  return pattern;
}

VertexMatch match_vertices(const MatchSide& last, const MatchSide& follower,
                           const MatchOptions& options) {
  VertexMatch match;
  match.by = options.by.value_or(same_connectivity(last.mesh, follower.mesh) ? Matching::number
                                                                             : Matching::position);
  if (match.by == Matching::number) check_numbers(last, follower);
  if (match.by == Matching::id) {
    match.counterparts = counterparts_by_id(last, follower, options.array);
  }
  return match;
}

CarriedPattern carry(const KeptPattern& last, const Follower& follower,
                     const MatchOptions& options) {
  const VertexMatch match = match_vertices(last.side(), follower.side(), options);
  CarriedPattern carried{match.by == Matching::position
                             ? carried_phases(last.view(), follower.mesh, follower.waves)
                             : matched_phases(last.view(), follower.waves, match.counterparts),
                         match.by, 0};
  for (std::size_t i = 0; i < carried.z.size(); ++i) {
    if (carried.z[i] == Complex(0) && !follower.waves.directions[i].isZero(0)) {
      ++carried.unmatched;
    }
  }
  return carried;
}

bool same_connectivity(const Mesh& a, const Mesh& b) {
  return a.vertex_count() == b.vertex_count() && a.triangles == b.triangles;
}

namespace {

std::vector<Vec3> normals_of_pattern(const KeptPattern& pattern, std::optional<int> neighbors) {
  if (!pattern.mesh.triangles.empty()) return vertex_normals(pattern.mesh);
  if (!pattern.normals.empty()) return pattern.normals;
  return make_point_surface(make_point_cloud(pattern.mesh.positions).cloud,
                            neighbors.value_or(kDefaultNeighbors))
      .normals;
}

}  // namespace

KeptField field_of(const KeptPattern& pattern, std::optional<int> neighbors) {
  KeptField field{pattern.name,
                  pattern.mesh,
                  normals_of_pattern(pattern, neighbors),
                  pattern.waves.directions,
                  pattern.arrays,
                  mean_period(pattern.waves)};
  const float back = -pattern.turn_deg * std::numbers::pi_v<float> / 180;
  if (back != 0) field.directions = rotated(field.directions, field.normals, back);
  return field;
}

std::string turn_note(const KeptPattern& pattern, const WaveOptions& waves) {
  const float now = turn_deg(waves);
  if (pattern.turn_deg == now) return "";
  return "the waves of " + shown(pattern.name) + " are turned from their field by " +
         formatted("%g", static_cast<double>(pattern.turn_deg)) + " degrees" +
         (find_array(pattern.arrays, kTurnArray) == nullptr
              ? std::string(" (it has no array '") + kTurnArray + "')"
              : std::string()) +
         ", these by " + formatted("%g", static_cast<double>(now)) +
         " (--rotate, --along): the field goes on\n";
}

DirectionField carry_field(const KeptField& last, const std::string& name,
                           const Preparation& prepared, const WaveOptions& waves,
                           const MatchOptions& options) {
  const Surface& surface = prepared.surface;
  const VertexMatch match = match_vertices({last.name, last.mesh, last.arrays},
                                           {name, surface.mesh, prepared.arrays.points}, options);
  const LastField field{last.mesh, last.normals, last.directions};
  if (match.by != Matching::position) return matched_directions(field, surface, match.counterparts);
  return carried_directions(field, surface, symmetry_of(waves), last.period);
}

}  // namespace brindle::tool
