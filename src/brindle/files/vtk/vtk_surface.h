/// Surfaces from VTK cells.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include "brindle/data_arrays.h"
#include "brindle/files/mesh_builder.h"
#include "brindle/files/read_arrays.h"
#include "brindle/types.h"

namespace brindle {

/// VTK's codes of some cell types.
inline constexpr std::uint8_t kVtkPolyVertex = 2, kVtkPolyLine = 4, kVtkTriangleStrip = 6,
                              kVtkPolygon = 7;

/// Cells in the file's form.
struct VtkCells {
  DataArray points;                 ///< point indices: the cells' lists, concatenated
  DataArray ends;                   ///< end of each cell's list
  std::vector<std::uint8_t> types;  ///< per cell
  std::uint8_t type = 0;            ///< the type of all cells if `types` is empty
};

/// The total length of all lists, and the cell types, from arrays of the file.
std::uint64_t vtk_points_of_cells(const DataArray& ends);
std::vector<std::uint8_t> vtk_cell_types(const DataArray& types);

/// Points and their cells, numbered in the order of `cells`.
struct VtkPiece {
  DataArray points;
  std::vector<VtkCells> cells;
  DataArrays arrays;    ///< a row per point and per cell
  std::string normals;  ///< name of the point array with the normals, or empty
};

// Surfaces of VTK volume cells.

/// The linear or quadratic type of a Lagrange or Bezier cell with `points` points; other types are
/// returned unchanged. (Bezier cells of order 2 have points off their surface.)
std::uint8_t vtk_plain_type(std::uint8_t type, std::size_t points);

/// Volume cells with known faces: tetrahedra, voxels, hexahedra, wedges, pyramids, prisms and their
/// quadratic forms.
class VtkVolumes {
 public:
  /// The smallest number of points of a cell of this type; 0 if its faces are unknown.
  static std::size_t points_of(std::uint8_t type);

  /// A cell of a known type with at least `points_of` points; `cell` is its row.
  void add(std::uint8_t type, std::span<const Index> points, Index cell);

  std::size_t count() const { return types_.size(); }

  /// Calls `use` with the corners of every face that belongs to one cell only, and the cell's row,
  /// in cell order. Mid-edge points are between the corners. Faces are wound anticlockwise from
  /// outside, whatever the order of the cell's points.
  void for_each_boundary_face(
      std::span<const Eigen::Vector3d> positions,
      const std::function<void(std::span<const Index> corners, Index cell)>& use) const;

 private:
  template <class Use>
  void for_each_face(const Use& use) const;
  std::vector<char> on_boundary() const;

  std::vector<std::uint8_t> types_;  ///< of each cell
  std::vector<Index> cells_;         ///< the row of each
  std::vector<Index> points_;        ///< of all cells, `points_of` each
};

// Surfaces of files.

/// Joins the surface cells of a file's pieces or, if it has volume cells only, their boundary.
class VtkSurface {
 public:
  /// `name` is that of the file, for errors.
  explicit VtkSurface(std::string name) : name_(std::move(name)) {}

  void add(VtkPiece piece);

  /// `exact`: see `MeshBuilder::take`.
  RawMesh take(std::vector<Eigen::Vector3d>* exact = nullptr);

 private:
  void add_points(const DataArray& points);
  void add_cells(const VtkCells& cells, Index first_point);
  void add_cell(std::uint8_t stored_type, std::span<const Index> points);
  /// A cell with mid-edge points, which follow its corners.
  void add_curved(std::span<const Index> points, std::size_t sides);
  void add_volume(std::uint8_t type, std::span<const Index> points);
  /// Takes the boundary of the volumes as the surface, and returns a line about it; empty if there
  /// is none.
  std::string take_boundary();
  std::string why_empty() const;
  [[noreturn]] void fail(const std::string& what) const;
  [[noreturn]] void fail_point(Index existing) const;
  void check_size(std::span<const Index> points, std::size_t least) const;
  std::string left_out() const;

  std::string name_;
  MeshBuilder builder_;
  PiecewiseArrays point_arrays_, cell_arrays_;
  std::string normals_;
  std::vector<Index> cell_points_,
      corners_;  ///< of one cell; members to reuse their memory
  Index cell_ = 0;
  VtkVolumes volumes_;
  std::size_t surfaces_ = 0;  ///< cells
  std::size_t unread_volumes_ = 0, points_ = 0, lines_ = 0, unknown_ = 0;
};

}  // namespace brindle
