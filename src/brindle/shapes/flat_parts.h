/// Built-in parts with flat faces and sharp edges, as CAD programs export them: few triangles, long
/// ones on flat faces, and as many as `resolution` says along rounded ones.
#pragma once

#include "brindle/mesh.h"

namespace brindle {

/// Two plates at right angles, each with a hole, and a fillet between them. One plate lies, the
/// other stands at its end.
struct BracketShape {
  float length = 2;  ///< of the plate that lies, along x
  float depth = 1.3f;
  float height = 1.6f;  ///< along z
  float thickness = 0.25f;
  float fillet = 0.3f;  ///< radius
  float hole = 0.25f;   ///< radius
  int resolution = 8;   ///< edges along a quarter of a circle
};

/// The radius that a hole must be below: half the depth, and half of what is flat of the shorter
/// plate.
float room_for_hole(const BracketShape& shape);

Mesh make_bracket(const BracketShape& shape = {});

/// A spur gear about the z axis. Teeth are trapezoids.
struct GearShape {
  int teeth = 24;
  float radius = 1;     ///< to the tips
  float tooth = 0.16f;  ///< height of a tooth
  float width = 0.5f;   ///< along z
  float bore = 0.35f;   ///< radius
  int resolution = 2;   ///< edges of the bore for each tooth
};

Mesh make_gear(const GearShape& shape = {});

}  // namespace brindle
