/// Meshes put together from coordinates in doubles and polygons.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "brindle/data_arrays.h"
#include "brindle/mesh.h"

namespace brindle {

/// Elements of a file besides its points.
struct FileElements {
  bool faces = false;
  bool lines = false;
};

/// A mesh file before its vertices are joined or its triangles repaired.
struct RawMesh {
  Mesh mesh;
  DataArrays arrays = {};     ///< a row per vertex and per triangle
  std::string left_out = {};  ///< lines for the user on parts of the file that are missing here
  std::string taken = {};     ///< lines for the user on replacements of parts of the file
  /// Of a mesh without triangles, the reason and the remedy, after "path: ".
  std::string why_empty = {};
  FileElements elements = {};  ///< of VTK's files; all cells but points and lines count as faces
  std::string normals = {};  ///< the array of points with the normals; empty if the file names none
};

class MeshBuilder {
 public:
  /// Makes room for so many more vertices.
  void reserve_vertices(std::size_t more);

  /// Makes room for so many more polygons with so many corners in all.
  void reserve_polygons(std::size_t more, std::size_t corners);

  void add_vertex(const Eigen::Vector3d& position) { positions_.push_back(position); }

  /// Corners are indices of vertices, which may be added later. `cell` is the polygon's row in the
  /// file's data per cell; without it polygons are cells.
  void add_polygon(std::span<const Index> corners, Index cell);
  void add_polygon(std::span<const Index> corners) {
    add_polygon(corners, static_cast<Index>(cells_.size()));
  }

  /// A triangle of every corner and the two before it, wound the other way round each time. Corners
  /// that repeat turn strips around or join them, and make no triangle of their own.
  void add_strip(std::span<const Index> corners, Index cell = 0);

  std::size_t vertex_count() const { return positions_.size(); }
  std::span<const Eigen::Vector3d> positions() const { return positions_; }

  /// The mesh, with polygons cut into triangles in their order. Its origin is `origin_near` of the
  /// vertices that polygons use, or of all if there is no polygon. The builder is empty then.
  /// `arrays` has a row per vertex and per cell, the result one per vertex and per triangle.
  /// `exact` receives the coordinates as they were added.
  RawMesh take(DataArrays arrays = {}, std::vector<Eigen::Vector3d>* exact = nullptr);

 private:
  template <class Use>
  void for_each_polygon(const Use& use) const;

  std::vector<Eigen::Vector3d> positions_;
  std::vector<Index> polygons_;  ///< each its number of corners, then these
  std::vector<Index> cells_;     ///< per polygon
};

}  // namespace brindle
