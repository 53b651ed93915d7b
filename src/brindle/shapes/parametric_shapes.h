/// Built-in shapes with a formula: planes, spheres, tubes, strips.
///
/// All are centred at the origin, about two units large, wound outwards (the plane: towards +z),
/// with near-equilateral triangles. `resolution` counts edges along a direction that each shape
/// names. Each consists of strips, and can be made as a whole (`mesh_of`) or in parts.
#pragma once

#include "brindle/shapes/strip_shape.h"

namespace brindle {

/// A rectangle in the plane z = 0 on a lattice of equilateral triangles.
struct PlaneShape {
  float width = 2;
  float height = 2;
  int resolution = 160;  ///< edges along x
};
StripShape plane_strips(const PlaneShape& shape = {});

/// The side surface of a cylinder, about the z axis.
struct CylinderShape {
  float radius = 0.5f;
  float height = 2;
  int resolution = 240;  ///< edges around
};
StripShape cylinder_strips(const CylinderShape& shape = {});

/// An open tube about an arc in the plane y = 0: a sleeve, a bottle or a horn.
struct TubeShape {
  float radius = 0.25f;
  float length = 2;     ///< along the arc
  float bend_deg = 60;  ///< turn of the arc
  float bulge =
      0;  ///< relative widening at a quarter of the length, and narrowing at three quarters
  float taper = 1;       ///< radius of the upper end over that of the lower one
  int resolution = 104;  ///< edges around
};
StripShape tube_strips(const TubeShape& shape = {});

/// An icosahedron whose faces are divided along great circles.
struct SphereShape {
  float radius = 1;
  int resolution = 56;  ///< edges along an edge of the icosahedron
};
StripShape sphere_strips(const SphereShape& shape = {});

/// Around the z axis. The vertices are a lattice in conformal coordinates, so that triangles are
/// near equilateral everywhere, but larger outside than inside.
struct TorusShape {
  float major = 0.7f;
  float minor = 0.3f;
  int resolution = 300;  ///< edges along the major circle
};
StripShape torus_strips(const TorusShape& shape = {});

/// A tube along a trefoil knot, of radius `radius`; the knot's extent in x and y is about 2.
struct TrefoilShape {
  float radius = 0.16f;
  int resolution = 56;  ///< edges around the tube
};
StripShape trefoil_strips(const TrefoilShape& shape = {});

/// The upper half of a sphere, open.
struct HemisphereShape {
  float radius = 1;
  int resolution = 110;  ///< edges from the pole to the rim
};
StripShape hemisphere_strips(const HemisphereShape& shape = {});

/// A strip of the given width with a half turn, joined at its ends: one side, one border.
struct MobiusShape {
  float radius = 0.75f;
  float width = 0.5f;
  int resolution = 56;  ///< edges across the strip
};
StripShape mobius_strips(const MobiusShape& shape = {});

/// Half-planes that share the z axis, at equal angles: edges there have `count` triangles.
struct SheetsShape {
  int count = 3;
  float width = 1;  ///< from the common edge outwards
  float height = 2;
  int resolution = 80;  ///< edges from the common edge outwards
};
StripShape sheets_strips(const SheetsShape& shape = {});

/// Separate spheres, tori and cylinders in turn, on a circle.
struct PiecesShape {
  int count = 5;
  int resolution = 20;  ///< as in SphereShape; the others have similar edge lengths
};
StripShape pieces_strips(const PiecesShape& shape = {});

}  // namespace brindle
