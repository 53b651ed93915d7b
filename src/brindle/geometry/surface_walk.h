/// Walks over a mesh from triangle to triangle.
#pragma once

#include <array>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "brindle/geometry/topology.h"
#include "brindle/mesh.h"
#include "brindle/polylines.h"

namespace brindle {

std::array<Eigen::Vector3d, 3> corners_of(const Mesh& mesh, std::size_t triangle);

/// A point of a triangle in space, exact enough far from zero.
Eigen::Vector3d position_in(const Mesh& mesh, const TrianglePoint& place);

/// Not of unit length; zero for a triangle without area.
Eigen::Vector3d normal_of(const std::array<Eigen::Vector3d, 3>& corners);

/// A walker in a triangle.
struct SurfaceWalker {
  Index triangle = 0;
  Eigen::Vector3d place;      ///< barycentric
  Eigen::Vector3d direction;  ///< unit, in the triangle's plane
  int entered = -1;           ///< the edge that was passed last, if any
};

/// The change of a walker's barycentric coordinates along its direction, per unit of length.
Eigen::Vector3d change_along(const std::array<Eigen::Vector3d, 3>& corners,
                             const Eigen::Vector3d& direction);

/// The distance straight on to the edge by which a walker leaves its triangle; infinite, without an
/// edge, where it never does.
struct WayOut {
  double distance;
  int edge;
};
WayOut way_out(const SurfaceWalker& walker, const Eigen::Vector3d& change);

/// Moves straight on into triangle `next` over `edge`, at the point with the weights `between` of
/// the edge's ends, the one of lower number first.
void enter_triangle(const Mesh& mesh, const MeshEdges& edges, Index next, Index edge,
                    const std::array<double, 2>& between, SurfaceWalker& walker);

/// Ways over one mesh; all of it must outlive this.
class SurfaceWays {
 public:
  SurfaceWays(const Mesh& mesh, const MeshEdges& edges) : mesh_(mesh), edges_(edges) {}

  /// The end of a straight walk from a place, along `way` in its triangle's plane and as long;
  /// shorter where it meets an edge that does not have exactly two triangles.
  TrianglePoint straight_on(const TrianglePoint& from, const Eigen::Vector3d& way) const;

  /// A piece within a triangle.
  struct Piece {
    Index triangle;
    std::array<double, 3> from, to;  ///< barycentric
  };

  /// Appends the pieces of a way between two places near to each other, in the plane through both
  /// that holds `upward`; nothing, and false, where that does not lead there.
  bool connect(const TrianglePoint& from, const TrianglePoint& to, const Eigen::Vector3d& upward,
               std::vector<Piece>& pieces) const;

 private:
  bool go_over(SurfaceWalker& walker, int edge) const;

  const Mesh& mesh_;
  const MeshEdges& edges_;
};

}  // namespace brindle
