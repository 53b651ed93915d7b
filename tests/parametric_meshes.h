/// Built-in shapes by their formulas, for tests that need other sizes than the defaults.
#pragma once

#include "brindle/shapes/parametric_shapes.h"

namespace brindle {

inline Mesh make_plane(const PlaneShape& shape = {}) { return mesh_of(plane_strips(shape)); }
inline Mesh make_cylinder(const CylinderShape& shape = {}) {
  return mesh_of(cylinder_strips(shape));
}
inline Mesh make_sphere(const SphereShape& shape = {}) { return mesh_of(sphere_strips(shape)); }
inline Mesh make_torus(const TorusShape& shape = {}) { return mesh_of(torus_strips(shape)); }
inline Mesh make_mobius(const MobiusShape& shape = {}) { return mesh_of(mobius_strips(shape)); }
inline Mesh make_sheets(const SheetsShape& shape = {}) { return mesh_of(sheets_strips(shape)); }
inline Mesh make_pieces(const PiecesShape& shape = {}) { return mesh_of(pieces_strips(shape)); }

}  // namespace brindle
