/// Areas of triangles and of the vertices' shares of the surface.
#pragma once

#include <vector>

#include "brindle/mesh.h"

namespace brindle {

/// In squared units of length.
float triangle_area(const Mesh& mesh, const Triangle& triangle);

/// A third of the area of all triangles around each vertex; zero for a vertex without a triangle.
std::vector<float> vertex_areas(const Mesh& mesh);

}  // namespace brindle
