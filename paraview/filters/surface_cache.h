/// The surface in what VTK hands over: polygons, cells of grids, blocks.
#pragma once

#include <array>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <brindle/data_arrays.h>
#include <brindle/mesh.h>
#include <brindle/progress.h>
#include <brindle/surface.h>
#include <vtkSmartPointer.h>
#include <vtkType.h>

class vtkAlgorithm;
class vtkDataArray;
class vtkDataObject;
class vtkPolyData;

namespace brindle::paraview {

/// A surface, and what its vertices and triangles were in VTK's data.
struct InputSurface {
  vtkSmartPointer<vtkPolyData> triangles;  ///< cells are triangles, without others
  std::shared_ptr<const Surface> surface;  ///< vertex i stands where point i of `triangles` does
  /// For every point the vertex that triangles use: of points at one place the first.
  std::vector<Index> vertex_of_point;
  std::vector<Index> cell_of_triangle;       ///< triangles without area are left out
  std::vector<Triangle> points_of_triangle;  ///< at its corners
  bool joined = false;                       ///< whether any point stands where another one does

  /// The array of that name, with a row per vertex: of cells (`of_points` false) the mean around
  /// it. Throws Error for an array that is not there or holds no numbers.
  DataArray array(const std::string& name, bool of_points) const;
};

/// Keeps the last input's surface for the next, if points and cells are the same: unchanged since,
/// or read again with the same numbers.
class SurfaceCache {
 public:
  /// The surface of polygons, of a grid's outer cells, or of all blocks in one; of blocks arrays
  /// count that all of them have. Null if there are no points. Valid until the next call. Throws
  /// Error if there is no triangle that has an area, and for coordinates that are not finite.
  /// `owner` is whose abort flag VTK's own filters follow.
  const InputSurface* surface_of(vtkDataObject* input, vtkAlgorithm* owner);

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

  void derive(const Mesh& raw);

  InputSurface current_;
  Mesh raw_;  ///< before points at one place were joined
  Stamp stamp_;
  int surfaces_made_ = 0;
};

}  // namespace brindle::paraview
