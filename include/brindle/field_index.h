/// Singularities of direction fields.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "brindle/export.h"
#include "brindle/mesh.h"
#include "brindle/types.h"

namespace BRINDLE_EXPORT brindle {

/// The index of an N-direction field (N = `symmetry`) on a triangle, in N-th parts of a whole turn,
/// counter-clockwise seen from the tip of `normal`; 0 without a singularity (Ray et al. 2008).
/// `normal` may have any length; `directions` are those of the corners.
int field_index(const Vec3& normal, const std::array<Vec3, 3>& directions, int symmetry);

/// A triangle with a singularity.
struct SingularTriangle {
  Index triangle;
  int index;  ///< `field_index`, not 0
};

/// The singular triangles of an N-direction field, in ascending order. Triangles with a corner
/// without a direction do not count. `directions` has one entry per vertex.
std::vector<SingularTriangle> singular_triangles(const Mesh& mesh, std::span<const Vec3> directions,
                                                 int symmetry);

/// The number of singular triangles.
std::size_t count_singularities(const Mesh& mesh, std::span<const Vec3> directions, int symmetry);

}  // namespace brindle
