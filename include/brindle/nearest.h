/// Nearest places and vertices of a mesh.
#pragma once

#include <array>
#include <limits>
#include <memory>
#include <optional>

#include "brindle/export.h"
#include "brindle/mesh.h"
#include "brindle/progress.h"
#include "brindle/types.h"

namespace BRINDLE_EXPORT brindle {

/// A place on a mesh's triangles.
struct PointOnMesh {
  Index triangle = 0;
  std::array<double, 3> barycentric{};                 ///< not negative, sums to 1
  Eigen::Vector3d position = Eigen::Vector3d::Zero();  ///< relative to the mesh's origin
  double distance = 0;                                 ///< from the query point
};

/// Finds the nearest place on a mesh's triangles of any shape: folded, flat, without area. Built
/// once, in O(n log n) for n triangles, then queried from any number of threads. Results do not
/// depend on the order of the search.
class NearestOnMesh {
 public:
  /// The mesh must outlive this object and stay unchanged. Throws Error as `make_surface` does, and
  /// Cancelled if `progress` cancels.
  explicit NearestOnMesh(const Mesh& mesh, const Progress& progress = {});
  explicit NearestOnMesh(Mesh&&, const Progress& = {}) = delete;
  ~NearestOnMesh();
  NearestOnMesh(NearestOnMesh&&) noexcept;
  NearestOnMesh& operator=(NearestOnMesh&&) noexcept;

  /// The place nearest to `point`, which is relative to the mesh's `origin`: shift a vertex of a
  /// mesh with another origin by the difference. Of equally near places, the one on the triangle
  /// with the smallest number. Empty if there is none within `max_distance`, or if a coordinate is
  /// not finite or beyond 1e150.
  std::optional<PointOnMesh> nearest(
      const Eigen::Vector3d& point,
      double max_distance = std::numeric_limits<double>::infinity()) const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// A vertex near a query point.
struct VertexNearby {
  Index vertex = 0;
  double distance = 0;
};

/// Finds the nearest vertex, also of a mesh without triangles.
class NearestVertex {
 public:
  /// The mesh must outlive this object and stay unchanged. Throws Error, naming the first vertex,
  /// for a position that is not finite, and Cancelled if `progress` cancels.
  explicit NearestVertex(const Mesh& mesh, const Progress& progress = {});
  explicit NearestVertex(Mesh&&, const Progress& = {}) = delete;
  ~NearestVertex();
  NearestVertex(NearestVertex&&) noexcept;
  NearestVertex& operator=(NearestVertex&&) noexcept;

  /// As `NearestOnMesh::nearest`; of equally near vertices, the one with the smallest number.
  std::optional<VertexNearby> nearest(
      const Eigen::Vector3d& point,
      double max_distance = std::numeric_limits<double>::infinity()) const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// Barycentric coordinates of the place in a triangle that is nearest to a point, relative to the
/// mesh's origin.
std::array<double, 3> nearest_in_triangle(const Mesh& mesh, const Triangle& triangle,
                                          const Eigen::Vector3d& point);

}  // namespace brindle
