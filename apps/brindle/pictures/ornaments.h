/// Surfaces with tubes along curves or discs at samples, for builds with OpenGL.
#pragma once

#include <span>
#include <vector>

#include "brindle/renderer.h"
#include "pictures/picture.h"

namespace brindle::tool {

/// All in one mesh, with normals and a colour per triangle.
struct OrnamentedSurface {
  Mesh mesh;
  std::vector<Vec3> normals;
  std::vector<TriangleColor> colors;

  /// Refers to all of it.
  SurfaceDrawing drawing() const;
};

/// The options' colour for the first pattern, another one for the second.
Color ornament_color(bool second, const RenderOptions& render);

/// In these colours.
OrnamentedSurface ornamented(const Surface& surface, std::span<const Ornament> ornaments,
                             const RenderOptions& render);

}  // namespace brindle::tool
