/// Surfaces with waves, ready to be solved, for the tests of several rooms.
#pragma once

#include <cmath>
#include <memory>
#include <random>
#include <string_view>
#include <utility>

#include "brindle/direction_field.h"
#include "brindle/frequency_field.h"
#include "brindle/geometry/topology.h"
#include "brindle/mesh.h"
#include "brindle/normals.h"
#include "brindle/phase_graph.h"
#include "brindle/shapes.h"

namespace brindle::testing_support {

/// Along no symmetry of any shape.
inline const Vec3 kAxis(0.31f, 0.9f, 0.27f);

struct WavySurface {
  Mesh mesh;
  std::vector<Vec3> normals;
  std::shared_ptr<const Adjacency> neighborhood;
  WaveSet waves;

  PhaseGraph graph(PhaseShiftKind kind = PhaseShiftKind::aligned) const {
    return build_phase_graph(neighborhood, waves, kind);
  }
};

/// A mesh with the global vector `axis` projected and `stripes` along its diagonal.
inline WavySurface wavy_surface(Mesh mesh, const Vec3& axis, float stripes) {
  WavySurface s;
  s.mesh = std::move(mesh);
  s.normals = vertex_normals(s.mesh);
  s.neighborhood = std::make_shared<const Adjacency>(vertex_neighborhood(s.mesh));
  s.waves = {
      s.mesh.positions, projected_direction_field(axis, s.normals),
      constant_frequency_field(frequency_of_stripes(stripes, bounding_box(s.mesh).diagonal()),
                               s.mesh.vertex_count())};
  return s;
}

/// A built-in shape.
inline WavySurface wavy_surface(std::string_view shape, const Vec3& axis, float stripes) {
  return wavy_surface(make_shape(shape), axis, stripes);
}

/// Turns about half of the directions round; returns which (1 or 0).
inline std::vector<std::uint8_t> flip_half(WaveSet& waves, std::uint32_t seed) {
  std::mt19937 random(seed);
  std::vector<std::uint8_t> flipped(waves.directions.size());
  for (std::size_t i = 0; i < flipped.size(); ++i) {
    flipped[i] = random() % 2;
    if (flipped[i]) waves.directions[i] = -waves.directions[i];
  }
  return flipped;
}

}  // namespace brindle::testing_support
