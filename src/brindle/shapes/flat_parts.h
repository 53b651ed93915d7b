/// Built-in parts with flat faces and sharp edges, like CAD exports: few long triangles on flat
/// faces, and `resolution` edges along rounded ones.
#pragma once

#include "brindle/mesh.h"

namespace brindle {

/// Two plates at right angles with a hole each and a fillet between them. One plate is horizontal,
/// the other stands at its end.
struct BracketShape {
  float length = 2;  ///< of the horizontal plate, along x
  float depth = 1.3f;
  float height = 1.6f;  ///< along z
  float thickness = 0.25f;
  float fillet = 0.3f;  ///< radius
  float hole = 0.25f;   ///< radius
  int resolution = 8;   ///< edges per quarter circle
};

/// The upper bound of the hole's radius: half the depth, and half the flat part of the shorter
/// plate.
float room_for_hole(const BracketShape& shape);

Mesh make_bracket(const BracketShape& shape = {});

/// A spur gear about the z axis, with trapezoidal teeth.
struct GearShape {
  int teeth = 24;
  float radius = 1;     ///< to the tips
  float tooth = 0.16f;  ///< height of a tooth
  float width = 0.5f;   ///< along z
  float bore = 0.35f;   ///< radius
  int resolution = 2;   ///< edges of the bore per tooth
};

Mesh make_gear(const GearShape& shape = {});

}  // namespace brindle
