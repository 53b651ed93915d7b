/// The surface in what VTK hands over, kept as long as it is the same.
#pragma once

#include <array>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include <brindle/creases.h>
#include <brindle/data_arrays.h>
#include <brindle/mesh.h>
#include <brindle/surface.h>
#include <vtkSmartPointer.h>
#include <vtkType.h>

#include "input_triangles.h"
#include "rank_piece.h"
#include "ranks.h"

class vtkAlgorithm;
class vtkDataArray;
class vtkDataObject;
class vtkPolyData;

namespace brindle::paraview {

/// A surface, and what its vertices and triangles were in VTK's data. Of points that are one vertex
/// all but one are in no triangle, but vertices all the same. Vertices on creases have copies
/// (`split_at_creases`), and points of their own for these, at the end. Over several ranks it is
/// that of this rank's points and triangles, ghosts included, with the normals of the whole; one
/// rank has no ghosts.
struct InputSurface {
  vtkSmartPointer<vtkPolyData> triangles;  ///< cells are triangles, without others
  std::shared_ptr<const Surface> surface;
  /// For every point the vertex that triangles use: of points that are one vertex
  /// (`global_numbers`) the first stands for all.
  std::vector<Index> vertex_of_point;
  std::vector<Index> point_of_vertex;        ///< the point that it stands for, or that does for it
  std::vector<Index> cell_of_triangle;       ///< triangles without area are left out
  std::vector<Triangle> points_of_triangle;  ///< at its corners
  std::vector<Index> copied_points;          ///< of those that creases add, in order
  bool joined = false;          ///< whether any point's vertex has another number than the point
  bool creases_missed = false;  ///< whether several ranks have creases, at which nothing is split
  bool ids_refused = false;     ///< whether points had ids that cannot be numbers in the whole
  std::shared_ptr<const RankPiece> piece;  ///< null if this process is alone

  /// Of vertices, where points have ids that say which vertex they are; else null.
  std::shared_ptr<const std::vector<std::uint64_t>> ids;

  /// The point itself, or of which it is a copy.
  Index source_of(Index point) const {
    const std::size_t own = vertex_of_point.size() - copied_points.size();
    return point < own ? point : copied_points[point - own];
  }

  /// The array of that name, with a row per vertex: of cells (`of_points` false) the mean around
  /// it. Collective over ranks. Throws Error for an array that is not there or holds no numbers.
  DataArray array(const std::string& name, bool of_points) const;

  /// The array of cells of that name, with a row per triangle; otherwise the same.
  DataArray array_of_triangles(const std::string& name) const;

 private:
  DataArray rows_of_piece(const std::string& name, bool of_points) const;
};

/// Where triangles were split last.
class KnownCreases {
 public:
  /// As `split_at_creases`; a mesh that has only moved is split where it was, so that its pattern
  /// can follow. Valid until the next call.
  const Creases& split(Mesh& mesh, float angle);

 private:
  float angle_ = 180;
  std::vector<Triangle> whole_;  ///< before the split
  std::vector<Triangle> split_;
  Creases creases_;
};

/// Keeps the last input's surface for the next, if points and cells are the same: unchanged since,
/// or read again with the same numbers.
class SurfaceCache {
 public:
  /// The surface of polygons, of a grid's outer cells, or of all blocks in one; of blocks arrays
  /// count that all of them have. Null if there are no points. Valid until the next call. Throws
  /// Error if there is no triangle that has an area, and for coordinates that are not finite.
  /// `owner` is whose abort flag VTK's own filters follow. Collective over ranks, which together
  /// have one surface; to any of them there may be nothing. One rank splits it at creases, edges
  /// that bend by more than `crease_angle` degrees, and keeps where while it only moves.
  const InputSurface* surface_of(vtkDataObject* input, vtkAlgorithm* owner, const Ranks& ranks,
                                 float crease_angle);

  /// How many times a surface was derived.
  int surfaces_made() const { return surfaces_made_; }

 private:
  /// What tells without looking at numbers that points and cells are those of before.
  struct Stamp {
    const void* points = nullptr;
    const void* cells = nullptr;
    vtkMTimeType time = 0;
    bool operator==(const Stamp&) const = default;
  };

  bool read(vtkPolyData& triangles);
  void derive(vtkPolyData& triangles, const Ranks& ranks, float crease_angle);

  InputSurface current_;
  KnownCreases creases_;
  RawMesh raw_;  ///< before points were joined
  Stamp stamp_;
  float crease_angle_ = 0;
  int surfaces_made_ = 0;
};

}  // namespace brindle::paraview
