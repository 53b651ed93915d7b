/// VTK's XML files: PolyData (.vtp) and UnstructuredGrid (.vtu).
#pragma once

#include <filesystem>
#include <vector>

#include "brindle/files/raw_mesh.h"
#include "brindle/progress.h"

namespace brindle {

/// As `read_vtk`, which chooses by extension.
/// `exact` receives the coordinates of all points as doubles: pieces of a surface are put about one
/// origin by those.
RawMesh read_vtk_xml(const std::filesystem::path& path, const Progress& progress,
                     std::vector<Eigen::Vector3d>* exact = nullptr);

}  // namespace brindle
