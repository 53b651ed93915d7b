/// Surfaces from VTK cells.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "brindle/data_arrays.h"
#include "brindle/files/mesh_builder.h"

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

/// The surface cells of a file's pieces or, if it has volume cells only, their boundary. `name` is
/// that of the file, for errors. `exact`: see `MeshBuilder::take`.
RawMesh vtk_surface(const std::string& name, std::vector<VtkPiece> pieces,
                    std::vector<Eigen::Vector3d>* exact = nullptr);

}  // namespace brindle
