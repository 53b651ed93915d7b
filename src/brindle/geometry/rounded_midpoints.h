/// Midpoints of edges on a surface that bends between its triangles.
#pragma once

#include <vector>

#include "brindle/geometry/normals_around.h"
#include "brindle/mesh.h"
#include "brindle/progress.h"

namespace brindle {

/// Edges become cubic curves at right angles to the normals at their ends (Vlachos et al. 2001).
/// Normals are those of an edge: averages over the triangles round its end whose normals are within
/// 40 degrees of the edge's own. An edge where the surface bends by more, or that has more than two
/// triangles, stays straight.
class RoundedMidpoints {
 public:
  /// Keeps a reference to the mesh. Throws Cancelled if `progress` asks for it.
  explicit RoundedMidpoints(const Mesh& mesh, const Progress& progress = {});

  /// From the middle between two neighbours to that of the curve. `a` and `b` may be swapped.
  Vec3 shift(Index a, Index b) const;

 private:
  Vec3 normal_of_edge(Index a, Index b) const;
  Vec3 normal_at(Index vertex, const Vec3& of_edge) const;

  const Mesh& mesh_;
  VertexTriangles around_;
  std::vector<TriangleAngles> angles_;
};

}  // namespace brindle
