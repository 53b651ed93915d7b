/// Builds meshes from double coordinates and polygons.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "brindle/data_arrays.h"
#include "brindle/mesh.h"

namespace brindle {

/// Elements of a file besides points.
struct FileElements {
  bool faces = false;
  bool lines = false;
};

/// A mesh file before its vertices are joined or its triangles repaired.
struct RawMesh {
  Mesh mesh;
  DataArrays arrays = {};     ///< a row per vertex and per triangle
  std::string left_out = {};  ///< lines for the user: parts of the file that were left out
  std::string taken = {};     ///< lines for the user: parts of the file that were replaced
  /// Without triangles, the reason and the remedy, after "path: ".
  std::string why_empty = {};
  /// Of VTK and OBJ files; all cells but points and lines count as faces.
  FileElements elements = {};
  std::string normals = {};  ///< name of the point array with the normals, or empty
};

class MeshBuilder {
 public:
  /// Reserves memory for `more` vertices.
  void reserve_vertices(std::size_t more);

  /// Reserves memory for `more` polygons with `corners` corners in total.
  void reserve_polygons(std::size_t more, std::size_t corners);

  void add_vertex(const Eigen::Vector3d& position) { positions_.push_back(position); }

  /// Corners are vertex indices; vertices may be added later. `cell` is the polygon's row in the
  /// file's cell data; without it, polygons are cells.
  void add_polygon(std::span<const Index> corners, Index cell);
  void add_polygon(std::span<const Index> corners) {
    add_polygon(corners, static_cast<Index>(cells_.size()));
  }

  /// A triangle strip, with alternating winding. Repeated corners swap or join strips and make no
  /// triangle.
  void add_strip(std::span<const Index> corners, Index cell = 0);

  std::size_t vertex_count() const { return positions_.size(); }
  std::span<const Eigen::Vector3d> positions() const { return positions_; }

  /// The mesh, with polygons triangulated in order; empties the builder. Its origin is
  /// `origin_near` of the vertices in polygons, or of all vertices without polygons. `arrays` has
  /// rows per vertex and cell, the result rows per vertex and triangle. `exact` receives the
  /// coordinates as added.
  RawMesh take(DataArrays arrays = {}, std::vector<Eigen::Vector3d>* exact = nullptr);

 private:
  template <class Use>
  void for_each_polygon(const Use& use) const;

  std::vector<Eigen::Vector3d> positions_;
  std::vector<Index> polygons_;  ///< for each, the number of corners, then the corners
  std::vector<Index> cells_;     ///< per polygon
};

}  // namespace brindle
