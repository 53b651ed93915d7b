/// VTK's own files: XML PolyData (.vtp) and UnstructuredGrid (.vtu), and legacy files (.vtk).
#pragma once

#include <filesystem>

#include "brindle/files/raw_mesh.h"
#include "brindle/progress.h"

namespace brindle {

/// Whether the extension is one of VTK's.
bool is_vtk_format(const std::filesystem::path& path);

/// Triangles, quadrangles, polygons, pixels and strips, also with points amid their sides, with all
/// arrays of points and cells that hold numbers; other cells are counted in `RawMesh::left_out`. Of
/// volume cells alone the faces that belong to one cell only, each with the data of its cell.
/// Throws Error, naming the file, the array where there is one, and the remedy, for files that are
/// damaged or truncated, hold something else, or are compressed otherwise than by zlib; and for
/// .vtp and .vtu in a build without BRINDLE_VTK.
RawMesh read_vtk(const std::filesystem::path& path, const Progress& progress = {});

}  // namespace brindle
