/// Nearest places of surfaces with or without triangles.
#pragma once

#include <array>
#include <limits>
#include <optional>

#include "brindle/mesh.h"
#include "brindle/nearest.h"
#include "brindle/progress.h"
#include "brindle/types.h"

namespace brindle {

/// A place in a triangle, or at a vertex of a surface without triangles.
struct NearbyPlace {
  std::optional<Index> triangle;
  Triangle corners;  ///< of the triangle, or three times the vertex
  std::array<double, 3> barycentric;
  Eigen::Vector3d position;  ///< relative to the mesh's origin
  double distance;           ///< from the query point
};

class NearestPlace {
 public:
  /// As the constructors of NearestOnMesh and NearestVertex.
  explicit NearestPlace(const Mesh& mesh, const Progress& progress = {}) : mesh_(mesh) {
    if (mesh.triangles.empty()) {
      vertices_.emplace(mesh, progress);
    } else {
      triangles_.emplace(mesh, progress);
    }
  }

  /// As `NearestOnMesh::nearest`.
  std::optional<NearbyPlace> nearest(
      const Eigen::Vector3d& point,
      double max_distance = std::numeric_limits<double>::infinity()) const {
    if (triangles_) {
      const auto found = triangles_->nearest(point, max_distance);
      if (!found) return {};
      return NearbyPlace{found->triangle, mesh_.triangles[found->triangle], found->barycentric,
                         found->position, found->distance};
    }
    const auto found = vertices_->nearest(point, max_distance);
    if (!found) return {};
    const Index v = found->vertex;
    return NearbyPlace{
        {}, {v, v, v}, {1, 0, 0}, mesh_.positions[v].cast<double>(), found->distance};
  }

 private:
  const Mesh& mesh_;
  std::optional<NearestOnMesh> triangles_;
  std::optional<NearestVertex> vertices_;
};

}  // namespace brindle
