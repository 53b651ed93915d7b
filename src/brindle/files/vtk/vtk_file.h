/// VTK's own files: XML PolyData (.vtp) and UnstructuredGrid (.vtu), and legacy files (.vtk).
#pragma once

#include <filesystem>
#include <vector>

#include "brindle/files/mesh_builder.h"
#include "brindle/progress.h"

namespace brindle {

/// Whether the extension is one of VTK's.
bool is_vtk_format(const std::filesystem::path& path);

/// Triangles, quadrangles, polygons, pixels and strips, also with points amid their sides, with all
/// arrays of points and cells that hold numbers; other cells are counted in `RawMesh::left_out`. A
/// file of volume cells alone gives the faces that belong to one cell only, with the cell's data.
/// Throws Error, naming the file, the array where there is one, and the remedy, for files that are
/// damaged or truncated, hold something else, or are compressed otherwise than by zlib; and for
/// .vtp and .vtu in a build without BRINDLE_VTK.
RawMesh read_vtk(const std::filesystem::path& path, const Progress& progress = {});

/// The same of .vtk, of versions 1 to 5, text or binary.
RawMesh read_vtk_legacy(const std::filesystem::path& path, const Progress& progress);

/// The same of .vtp and .vtu. `exact` receives the coordinates of all points as doubles: pieces of
/// a surface are put about one origin by those.
RawMesh read_vtk_xml(const std::filesystem::path& path, const Progress& progress,
                     std::vector<Eigen::Vector3d>* exact = nullptr);

}  // namespace brindle
