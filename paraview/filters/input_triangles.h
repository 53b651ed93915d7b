/// Triangles of VTK data: polygons, cells of grids, blocks.
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

/// Adds ghost flags to all blocks if one has them: merging blocks drops arrays that some lack.
/// Returns other data unchanged.
vtkSmartPointer<vtkDataObject> with_ghosts_of_all(vtkDataObject* input);

/// Polygons, a grid's outer cells, or all blocks in one. Throws Error for data without a surface.
/// VTK's filters use the abort flag of `owner`.
vtkSmartPointer<vtkPolyData> polygons_of(vtkDataObject* input, vtkAlgorithm* owner);

/// The polygons and strips, triangulated as the library does for files (polygon.h), in coordinates
/// relative to `origin`; other cells are left out. Throws Error for corners that do not exist.
vtkSmartPointer<vtkPolyData> triangles_of(vtkSmartPointer<vtkPolyData> polygons,
                                          const Eigen::Vector3d& origin);

/// Positions relative to an origin.
std::vector<Vec3> positions_about(const Eigen::Vector3d& origin, vtkPolyData& data);

/// The points' global numbers, from VTK's attribute; may be empty.
std::vector<std::int64_t> ids_of(vtkPolyData& data);

/// The numbers of triangles.
struct RawMesh {
  Mesh mesh;
  std::vector<std::uint8_t> ghosts;  ///< per triangle: 1 for VTK's ghosts; may be empty
  std::vector<std::int64_t> ids;     ///< of points, global; may be empty
};

/// With VTK's data about other ranks. Throws Error for coordinates that are not finite.
RawMesh raw_mesh(vtkPolyData& triangles);

bool same(const RawMesh& a, const RawMesh& b);

}  // namespace brindle::paraview
