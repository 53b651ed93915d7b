/// Converts VTK data to a surface, cached while unchanged.
#pragma once

#include <array>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include <brindle/creases.h>
#include <brindle/data_arrays.h>
#include <brindle/mesh.h>
#include <brindle/polylines.h>
#include <brindle/surface.h>
#include <vtkSmartPointer.h>
#include <vtkType.h>

#include "input_triangles.h"
#include "rank_piece.h"
#include "ranks.h"

class vtkAlgorithm;
class vtkDataArray;
class vtkDataObject;
class vtkDataSetAttributes;
class vtkPolyData;

namespace brindle::paraview {

/// A surface, and the relation of its vertices and triangles to VTK's data. Of several points that
/// are one vertex, only the first has triangles, but all are vertices. Vertices on creases have
/// copies (`split_at_creases`), with points of their own at the end. With several ranks, it has
/// this rank's points and triangles, including ghosts, with normals of the whole; a single rank has
/// no ghosts.
struct InputSurface {
  vtkSmartPointer<vtkPolyData> triangles;  ///< all cells are triangles
  std::shared_ptr<const Surface> surface;
  /// The vertex of every point: the first of the points that are one vertex (`global_numbers`).
  std::vector<Index> vertex_of_point;
  std::vector<Index> point_of_vertex;        ///< the point of each vertex, or of its replacement
  std::vector<Index> cell_of_triangle;       ///< without degenerate triangles
  std::vector<Triangle> points_of_triangle;  ///< the points at its corners
  std::vector<Index> copied_points;          ///< sources of the points added by creases, in order
  bool joined = false;                       ///< whether any point was joined to another
  bool ids_refused = false;                  ///< whether ids were rejected as global numbers
  std::shared_ptr<const RankPiece> piece;    ///< null for a single process

  /// Ids of vertices, if points have valid ids; else null.
  std::shared_ptr<const std::vector<std::uint64_t>> ids;

  /// The point itself, or the source of a copy.
  Index source_of(Index point) const {
    const std::size_t own = vertex_of_point.size() - copied_points.size();
    return point < own ? point : copied_points[point - own];
  }

  /// Collective. The array of points of that name, with a row per vertex. Throws Error if the array
  /// is missing or not numeric.
  DataArray array_of_vertices(const std::string& name) const;

  /// The cell array of that name with a row per triangle; throws the same.
  DataArray array_of_triangles(const std::string& name) const;

  /// Collective. Rows of triangles, averaged at the vertices.
  DataArray cells_to_points(const DataArray& rows) const;

  /// Adds the arrays with a row per place on the triangles, interpolated point arrays and then cell
  /// arrays, except for names already taken.
  void carry_to_places(std::span<const TrianglePoint> places, vtkDataSetAttributes& points) const;

 private:
  DataArray rows_of_piece(const std::string& name, bool of_points) const;
};

/// Remembers where triangles were split.
class KnownCreases {
 public:
  /// As `split_at_creases`; a mesh that has only moved is split where it was before, so that its
  /// pattern can continue. Valid until the next call.
  const Creases& split(Mesh& mesh, float angle);

 private:
  float angle_ = 180;
  std::vector<Triangle> whole_;  ///< before the split
  std::vector<Triangle> split_;
  Creases creases_;
};

/// Reuses the last input's surface if points and cells are the same: not modified, or read again
/// with equal numbers.
class SurfaceCache {
 public:
  /// Collective. The surface of polygons, of a grid's outer cells, or of all blocks in one, with
  /// the arrays that all blocks have. Null without points. Valid until the next call. Throws Error
  /// if no triangle has an area, and for coordinates that are not finite. VTK's filters use the
  /// abort flag of `owner`. All ranks together have one surface; some may be empty. It is split
  /// at creases, edges that bend by more than `crease_angle` degrees; on a single rank in the same
  /// places while it only moves.
  const InputSurface* surface_of(vtkDataObject* input, vtkAlgorithm* owner, const Ranks& ranks,
                                 float crease_angle);

  /// The number of derived surfaces.
  int surfaces_made() const { return surfaces_made_; }

 private:
  /// Identifies points and cells by modification, without reading numbers.
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
