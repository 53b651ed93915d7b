/// How square a texture's tiles are.
#pragma once

#include "brindle/pattern/texture_waves.h"

namespace brindle {

/// Distortion of the unit square of texture coordinates against its target, a rectangle of
/// 1 / f_U by 1 / f_V, over all triangles that have an orientation and no vertex in common with a
/// branch or a singularity.
struct TextureQuality {
  std::size_t measured_triangles = 0;
  double angle_mean_deg = 0;  ///< between the square's angle on the surface and 90 degrees
  double angle_95th_deg = 0;  ///< 95 % of the triangles stay below
  double area_mean = 0;       ///< of max(a, 1/a) - 1 with a = its area times f_U f_V; at most 99
  double area_95th = 0;
};

/// Triangles count alike. `waves` has one entry per triangle, its corners oriented.
TextureQuality measure_texture(const Mesh& mesh, const TextureWaves& waves, PhaseShiftKind kind);

}  // namespace brindle
