/// The nearest places and vertices of a mesh.
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

/// The nearest place of a mesh's triangles, of any kind: bent, flat, without area. Built once, in
/// time O(n log n) for n triangles, then queried from any number of threads. Results do not depend
/// on the order of the search.
class NearestOnMesh {
 public:
  /// The mesh must outlive this and stay as it is. Throws Error as `make_surface` does, and
  /// Cancelled if `progress` asks for it.
  explicit NearestOnMesh(const Mesh& mesh, const Progress& progress = {});
  explicit NearestOnMesh(Mesh&&, const Progress& = {}) = delete;
  ~NearestOnMesh();
  NearestOnMesh(NearestOnMesh&&) noexcept;
  NearestOnMesh& operator=(NearestOnMesh&&) noexcept;

  /// The place nearest to `point`, which is relative to the mesh's `origin`: a vertex of a mesh
  /// with another origin must be moved by the difference of both. Of places equally near, the one
  /// on the triangle with the smallest number. None if there is none within `max_distance`, or if a
  /// coordinate is not finite or beyond 1e150.
  std::optional<PointOnMesh> nearest(
      const Eigen::Vector3d& point,
      double max_distance = std::numeric_limits<double>::infinity()) const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

struct VertexNearby {
  Index vertex = 0;
  double distance = 0;
};

/// The nearest vertex, also of a mesh without triangles.
class NearestVertex {
 public:
  /// The mesh must outlive this and stay as it is. Throws Error, naming the first vertex, for a
  /// position that is not finite, and Cancelled if `progress` asks for it.
  explicit NearestVertex(const Mesh& mesh, const Progress& progress = {});
  explicit NearestVertex(Mesh&&, const Progress& = {}) = delete;
  ~NearestVertex();
  NearestVertex(NearestVertex&&) noexcept;
  NearestVertex& operator=(NearestVertex&&) noexcept;

  /// As `NearestOnMesh::nearest`; of vertices equally near the one with the smallest number.
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
