/// Straight lines within triangles, and the lines on a surface that they join to.
#pragma once

#include <array>
#include <span>
#include <vector>

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

/// Where values that are linear between corners a and b of a triangle pass zero.
CornerWeights zero_between(int a, int b, double value_a, double value_b);

/// Segments joined at their nodes, as long as no more than two of them meet there. `normals` has
/// one unit normal per vertex.
Polylines joined_lines(const Mesh& mesh, std::span<const Vec3> normals,
                       std::span<const LineSegment> segments);

}  // namespace brindle
