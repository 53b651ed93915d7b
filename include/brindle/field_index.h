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

/// How often N-fold directions turn round a triangle, counter-clockwise seen from the tip of
/// `normal`, in N-th parts of a whole turn: 0 where the field has no singularity (Ray et al. 2008).
/// `normal` is of any length, `directions` are those of the corners.
int field_index(const Vec3& normal, const std::array<Vec3, 3>& directions, int symmetry);

struct SingularTriangle {
  Index triangle;
  int index;  ///< of `field_index`, not 0
};

/// The triangles that a field of symmetry N turns round, of those whose corners all have a
/// direction, in their order.
std::vector<SingularTriangle> singular_triangles(const Mesh& mesh, std::span<const Vec3> directions,
                                                 int symmetry);

/// How many there are.
std::size_t count_singularities(const Mesh& mesh, std::span<const Vec3> directions, int symmetry);

}  // namespace brindle
