/// The triangles in what VTK hands over: polygons, cells of grids, blocks.
#pragma once

#include <cstdint>
#include <vector>

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

/// The same cut into triangles; cells of other kinds are left out. Throws Error for corners that
/// are no points.
vtkSmartPointer<vtkPolyData> triangles_of(vtkSmartPointer<vtkPolyData> polygons,
                                          vtkAlgorithm* owner);

/// What of triangles is numbers.
struct RawMesh {
  Mesh mesh;
  std::vector<std::uint8_t>
      ghosts;                     ///< per triangle: 1 if VTK says that another rank has it; or none
  std::vector<std::int64_t> ids;  ///< of points in the whole; or none
};

/// Throws Error for coordinates that are not finite.
Mesh raw_mesh(vtkPolyData& triangles);

/// The same, with what VTK knows of other ranks.
RawMesh raw_piece(vtkPolyData& triangles);

bool same(const RawMesh& a, const RawMesh& b);

}  // namespace brindle::paraview
