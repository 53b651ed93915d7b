/// The triangles in what VTK hands over: polygons, cells of grids, blocks.
#pragma once

#include <cstdint>
#include <vector>

#include <Eigen/Core>
#include <brindle/mesh.h>
#include <vtkSmartPointer.h>

class vtkAlgorithm;
class vtkDataObject;
class vtkPolyData;

namespace brindle::paraview {

/// Blocks of which each says what cells are ghosts, if one does: of arrays that not all blocks have
/// nothing is left when they become one. Other data as they are.
vtkSmartPointer<vtkDataObject> with_ghosts_of_all(vtkDataObject* input);

/// Polygons, a grid's outer cells, or all blocks in one. Throws Error for what has no surface.
/// `owner` is whose abort flag VTK's own filters follow.
vtkSmartPointer<vtkPolyData> polygons_of(vtkDataObject* input, vtkAlgorithm* owner);

/// The same cut into triangles, as the library cuts polygons of files (polygon.h); strips of
/// triangles are taken apart, and cells of other kinds left out. Cuts are made of coordinates
/// relative to `origin`. Throws Error for corners that are no points.
vtkSmartPointer<vtkPolyData> triangles_of(vtkSmartPointer<vtkPolyData> polygons,
                                          const Eigen::Vector3d& origin);

/// Where points stand relative to an origin.
std::vector<Vec3> positions_about(const Eigen::Vector3d& origin, vtkPolyData& data);

/// The points' numbers in the whole, as VTK's attribute has them; or none.
std::vector<std::int64_t> ids_of(vtkPolyData& data);

/// What of triangles is numbers.
struct RawMesh {
  Mesh mesh;
  std::vector<std::uint8_t>
      ghosts;  ///< per triangle: 1 if VTK says that another piece has it; or none
  std::vector<std::int64_t> ids;  ///< of points in the whole; or none
};

/// With what VTK knows of other pieces. Throws Error for coordinates that are not finite.
RawMesh raw_mesh(vtkPolyData& triangles);

bool same(const RawMesh& a, const RawMesh& b);

}  // namespace brindle::paraview
