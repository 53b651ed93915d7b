/// Principal curvatures and their directions.
#pragma once

#include <span>
#include <vector>

#include "brindle/export.h"
#include "brindle/mesh.h"
#include "brindle/progress.h"
#include "brindle/types.h"

namespace BRINDLE_EXPORT brindle {

/// Principal curvatures at a vertex, in 1 / length, positive where the surface bends away from its
/// normal (a sphere of radius r wound outwards has 1 / r). `maximum` has the larger absolute value.
struct PrincipalCurvature {
  float maximum = 0;
  float minimum = 0;
  Vec3 maximum_direction = Vec3::Zero();  ///< unit tangent vector, up to sign
  Vec3 minimum_direction = Vec3::Zero();  ///< unit tangent vector, orthogonal to the other
};

/// One value per vertex, by a least-squares fit of the shape operator to the change of the normal
/// along the edges of each vertex. Vertices without neighbours have zero directions. Throws
/// Cancelled if `progress` asks for it.
std::vector<PrincipalCurvature> principal_curvatures(std::span<const Vec3> positions,
                                                     std::span<const Vec3> normals,
                                                     const Adjacency& neighborhood,
                                                     const Progress& progress = {});

}  // namespace brindle
