/// Surfaces out of VTK's cells.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "brindle/base/input_file.h"
#include "brindle/data_arrays.h"
#include "brindle/files/mesh_builder.h"
#include "brindle/files/piecewise_arrays.h"
#include "brindle/files/raw_mesh.h"
#include "brindle/files/vtk/vtk_volume.h"

namespace brindle {

/// VTK's numbers of some types of cells.
inline constexpr std::uint8_t kVtkPolyVertex = 2, kVtkPolyLine = 4, kVtkTriangleStrip = 6,
                              kVtkPolygon = 7;

/// Cells as a file lists them.
struct VtkCells {
  DataArray points;                 ///< numbers of points, those of all cells in one row
  DataArray ends;                   ///< of each cell where its points end in this row
  std::vector<std::uint8_t> types;  ///< of each cell
  std::uint8_t type = 0;            ///< of all cells, where `types` is empty
};

/// How many points the cells have in all, and the types of cells, of arrays that say so.
std::uint64_t vtk_points_of_cells(const DataArray& ends);
std::vector<std::uint8_t> vtk_cell_types(const DataArray& types);

/// Points with cells over them, numbered in the order of `cells`.
struct VtkPiece {
  DataArray points;
  std::vector<VtkCells> cells;
  DataArrays arrays;    ///< a row per point and per cell
  std::string normals;  ///< the array of points that the file says are normals, or nothing
};

/// Puts the surface cells of a file's pieces together; or, if there are volume cells alone, their
/// boundary.
class VtkSurface {
 public:
  /// Throws for what is wrong through `file`, which must live on.
  explicit VtkSurface(const InputFile& file) : file_(file) {}

  void add(VtkPiece piece);

  /// `exact`: as of `MeshBuilder::take`.
  RawMesh take(std::vector<Eigen::Vector3d>* exact = nullptr);

 private:
  void add_points(const DataArray& points);
  void add_cells(const VtkCells& cells, Index first_point);
  void add_cell(std::uint8_t stored_type, std::span<const Index> points);
  /// A cell with points amid its sides, which follow its corners.
  void add_curved(std::span<const Index> points, std::size_t sides);
  void add_volume(std::uint8_t type, std::span<const Index> points);
  /// A line on the boundary, which becomes the surface; nothing if it does not.
  std::string take_boundary();
  std::string why_empty() const;
  [[noreturn]] void fail_point(Index existing) const;
  void check_size(std::span<const Index> points, std::size_t least) const;
  std::string left_out() const;

  const InputFile& file_;
  MeshBuilder builder_;
  PiecewiseArrays point_arrays_, cell_arrays_;
  std::string normals_;
  std::vector<Index> cell_points_, corners_;  ///< of one cell, kept for their memory
  Index cell_ = 0;
  VtkVolumes volumes_;
  std::size_t surfaces_ = 0;  ///< cells
  std::size_t unread_volumes_ = 0, points_and_lines_ = 0, unknown_ = 0;
};

}  // namespace brindle
