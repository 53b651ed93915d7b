#include "input/followed_field.h"

#include <numbers>

#include "brindle/base/text.h"
#include "brindle/normals.h"
#include "brindle/pattern_arrays.h"
#include "brindle/points.h"
#include "input/surface_options.h"

namespace brindle::tool {
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
