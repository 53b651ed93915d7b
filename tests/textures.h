/// Textures on surfaces, for the tests of several rooms.
#pragma once

#include <cmath>
#include <string_view>
#include <vector>

#include "brindle/direction_field.h"
#include "brindle/geometry/topology.h"
#include "brindle/shapes.h"
#include "brindle/texture_pattern.h"

namespace brindle::testing_support {

inline WaveSet waves_of(const Surface& surface, DirectionField directions, float stripes) {
  const float frequency = frequency_of_stripes(stripes, bounding_box(surface.mesh).diagonal());
  return {surface.mesh.positions, std::move(directions),
          constant_frequency_field(frequency, surface.mesh.vertex_count())};
}

/// A texture along a global vector projected into the tangent planes.
inline TexturePattern texture_along(const Surface& surface, const Vec3& axis, float stripes,
                                    const TextureOptions& options = {}) {
  return texture_pattern(
      surface, waves_of(surface, projected_direction_field(axis, surface.normals), stripes),
      options);
}

/// Whether U and V disagree on whether waves run alike: between the ends of the edge, whose frames
/// are then a right angle or more apart, or between its sides at one end. No turn of both fits.
inline bool is_torn(const TextureWaves& waves, const SharedEdge& edge) {
  const auto disagree = [&](Index a, Index b) {
    const auto alike = [&](const std::vector<CornerWaves>& corners) {
      return corners[a / 3][a % 3].wave.direction.dot(corners[b / 3][b % 3].wave.direction) >= 0;
    };
    return alike(waves.u) != alike(waves.v);
  };
  return disagree(edge.from[0], edge.to[0]) || disagree(edge.from[0], edge.from[1]) ||
         disagree(edge.to[0], edge.to[1]);
}

/// Directions in the plane z = 0 that turn `index` times on the way around a point near zero.
inline DirectionField singular_field(const Mesh& plane, float index) {
  DirectionField field;
  for (const Vec3& p : plane.positions) {
    const float angle = index * std::atan2(p.y() - 0.0071f, p.x() + 0.0043f);
    field.emplace_back(std::cos(angle), std::sin(angle), 0);
  }
  return field;
}

}  // namespace brindle::testing_support
