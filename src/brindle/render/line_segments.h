/// Line segments within triangles, joined to lines on a surface.
#pragma once

#include <array>
#include <span>

#include "brindle/mesh.h"
#include "brindle/polylines.h"

namespace brindle {

using CornerWeights = std::array<double, 3>;  ///< barycentric

/// A straight line within a triangle, between two numbered nodes.
struct LineSegment {
  std::array<Index, 2> nodes;
  Index triangle;
  std::array<CornerWeights, 2> barycentric;
};

/// The zero of values that are linear between corners a and b of a triangle.
CornerWeights zero_between(int a, int b, double value_a, double value_b);

/// Segments joined at nodes where at most two of them meet. `normals`: one unit normal per vertex.
Polylines joined_lines(const Mesh& mesh, std::span<const Vec3> normals,
                       std::span<const LineSegment> segments);

}  // namespace brindle
