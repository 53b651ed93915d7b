/// VTK's formats: XML PolyData (.vtp), UnstructuredGrid (.vtu) and legacy files (.vtk).
#pragma once

#include <filesystem>
#include <vector>

#include "brindle/files/mesh_builder.h"
#include "brindle/progress.h"

namespace brindle {

/// Whether the extension is one of VTK's.
bool is_vtk_format(const std::filesystem::path& path);

/// Surface cells: triangles, quadrangles, polygons, pixels and strips, also quadratic ones, with
/// all numeric point and cell arrays. `RawMesh::left_out` counts other cells. A file with volume
/// cells only gives the faces that belong to one cell, with its data. Throws Error with the file,
/// the array if any, and the remedy for damaged, truncated or other files, for other compression
/// than zlib, and for .vtp and .vtu in builds without BRINDLE_VTK.
RawMesh read_vtk(const std::filesystem::path& path, const Progress& progress = {});

/// The same for .vtk, versions 1 to 5, text or binary.
RawMesh read_vtk_legacy(const std::filesystem::path& path, const Progress& progress);

/// The same for .vtp and .vtu. `exact` receives the coordinates of all points as doubles, which
/// place pieces about a common origin.
RawMesh read_vtk_xml(const std::filesystem::path& path, const Progress& progress,
                     std::vector<Eigen::Vector3d>* exact = nullptr);

}  // namespace brindle
