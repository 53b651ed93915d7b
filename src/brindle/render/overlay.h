/// What a picture shows on top of the stripes: coloured triangles and marks (paper, Fig. 8).
#pragma once

#include <span>
#include <vector>

#include "brindle/geometry/mesh.h"
#include "brindle/pattern/corner_phases.h"
#include "brindle/render/color.h"

namespace brindle {

/// A triangle's colour; `amount` 0 shows the stripes alone, 1 the colour alone.
struct TriangleColor {
  Color color;
  float amount = 0;
};

/// A disc that faces the camera, of a size in pixels, hidden by what is in front of it.
struct Mark {
  Vec3 position;
  Color color;
};

struct Overlay {
  std::vector<TriangleColor> triangle_colors;  ///< one per triangle, or empty
  std::vector<Mark> marks;
};

/// Branches in red and singularities of the field in amber, each with a mark at its centre so that
/// tiny triangles are found. `corners` has one entry per triangle.
Overlay branch_overlay(const Mesh& mesh, std::span<const CornerPhases> corners);

/// One value per triangle through `error_color`, from 0 to `largest`; negative values and NaN (no
/// value) leave a triangle as it is.
Overlay error_overlay(std::span<const float> values, float largest);

}  // namespace brindle
