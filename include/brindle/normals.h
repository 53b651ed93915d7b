/// Unit normals of triangles and vertices, and principal curvatures.
#pragma once

#include <span>
#include <vector>

#include "brindle/export.h"
#include "brindle/mesh.h"
#include "brindle/progress.h"
#include "brindle/types.h"

namespace BRINDLE_EXPORT brindle {

/// The unit normal of a triangle by the right-hand rule; zero if it has no area.
Vec3 triangle_normal(const Mesh& mesh, const Triangle& triangle);

/// One unit normal per vertex: the average of the adjacent triangles' normals, weighted by the
/// angle at the vertex (Thürmer and Wüthrich 1998). If triangles of an orientable component are
/// wound against each other, all count as wound outwards if it is closed, else as most are. Where
/// neighbours cannot be wound alike (Möbius strip, three sheets) the average would cancel; there
/// the normal is the direction that agrees best with all of them up to sign. Zero for a vertex
/// without a triangle.
std::vector<Vec3> vertex_normals(const Mesh& mesh);

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
/// Cancelled if `progress` cancels.
std::vector<PrincipalCurvature> principal_curvatures(std::span<const Vec3> positions,
                                                     std::span<const Vec3> normals,
                                                     const Adjacency& neighborhood,
                                                     const Progress& progress = {});

}  // namespace brindle
