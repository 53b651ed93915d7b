/// Smooth direction fields by the multilevel phase solver (DESIGN section 2).
#pragma once

#include "brindle/geometry/surface.h"
#include "brindle/waves/direction_field.h"

namespace brindle {

struct SmoothFieldOptions {
  int symmetry = 2;            ///< N: 1 vector, 2 line, 4 cross field
  float curvature_anchor = 0;  ///< how strongly principal curvature attracts the field; 0: not
  CurvatureDirection curvature_direction = CurvatureDirection::maximum;
  float feature_anchor = 0;  ///< how strongly sharp edges and boundaries attract the field, so that
                             ///< one of its directions runs along them; 0: not
  float feature_angle_deg = 40;  ///< an edge is sharp if the surface bends there by more than this
  int sweeps = 4;                ///< coloured sweeps per level
  int cycles = 2;                ///< further descents, which remove pairs of singularities
};

/// A direction field that turns as little as possible from vertex to vertex: each direction's angle
/// theta in its tangent basis enters as u = exp(i N theta), coupled by parallel transport.
/// Directions are signed to run like their neighbours where that is possible. Throws Error for
/// options out of range, among them feature anchors with an odd symmetry (an edge has no sign), and
/// for positions and normals that are not finite.
DirectionField smooth_direction_field(const Surface& surface,
                                      const SmoothFieldOptions& options = {});

}  // namespace brindle
