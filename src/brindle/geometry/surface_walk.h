/// Walks over a mesh from triangle to triangle.
#pragma once

#include <array>
#include <vector>

#include <Eigen/Core>

#include "brindle/geometry/topology.h"
#include "brindle/mesh.h"
#include "brindle/polylines.h"

namespace brindle {

std::array<Eigen::Vector3d, 3> corners_of(const Mesh& mesh, std::size_t triangle);

/// Position of a point in a triangle, accurate far from the origin.
Eigen::Vector3d position_in(const Mesh& mesh, const TrianglePoint& place);

/// Normal of any length; zero for a triangle without area.
Eigen::Vector3d normal_of(const std::array<Eigen::Vector3d, 3>& corners);

/// A point that moves in a triangle.
struct SurfaceWalker {
  Index triangle = 0;
  Eigen::Vector3d place;      ///< barycentric
  Eigen::Vector3d direction;  ///< unit, in the triangle's plane
  int entered = -1;           ///< edge crossed last; -1: none
};

/// Derivative of a walker's barycentric coordinates along its direction, per unit length.
Eigen::Vector3d change_along(const std::array<Eigen::Vector3d, 3>& corners,
                             const Eigen::Vector3d& direction);

/// Distance and edge at which a walker leaves its triangle; infinite, without an edge, if it never
/// does.
struct WayOut {
  double distance;
  int edge;
};
WayOut way_out(const SurfaceWalker& walker, const Eigen::Vector3d& change);

/// Continues straight into triangle `next` across `edge`, at the point with the weights `between`
/// of the edge's ends, lower number first.
void enter_triangle(const Mesh& mesh, const MeshEdges& edges, Index next, Index edge,
                    const std::array<double, 2>& between, SurfaceWalker& walker);

/// Straight paths on a mesh. The arguments must outlive this object.
class SurfaceWays {
 public:
  SurfaceWays(const Mesh& mesh, const MeshEdges& edges) : mesh_(mesh), edges_(edges) {}

  /// End of a straight path from a point, with the direction (in its triangle's plane) and length
  /// of `way`. Stops at edges without exactly two triangles.
  TrianglePoint straight_on(const TrianglePoint& from, const Eigen::Vector3d& way) const;

  /// A segment within a triangle.
  struct Piece {
    Index triangle;
    std::array<double, 3> from, to;  ///< barycentric
  };

  /// Appends the segments of a path between two nearby points, in the plane through both that
  /// contains `upward`. Returns false and appends nothing if it does not reach `to`.
  bool connect(const TrianglePoint& from, const TrianglePoint& to, const Eigen::Vector3d& upward,
               std::vector<Piece>& pieces) const;

 private:
  bool go_over(SurfaceWalker& walker, int edge) const;

  const Mesh& mesh_;
  const MeshEdges& edges_;
};

}  // namespace brindle
