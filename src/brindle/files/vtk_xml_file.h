/// VTK's XML files: PolyData (.vtp) and UnstructuredGrid (.vtu).
#pragma once

#include <filesystem>
#include <vector>

#include "brindle/files/raw_mesh.h"
#include "brindle/progress.h"

namespace brindle {

/// As `read_vtk` and `vtk_has_faces`, which choose by extension.
/// `exact` receives the coordinates of all points as doubles: pieces of a surface are put about one
/// origin by those.
RawMesh read_vtk_xml(const std::filesystem::path& path, const Progress& progress,
                     std::vector<Eigen::Vector3d>* exact = nullptr);
bool vtk_xml_has_faces(const std::filesystem::path& path);

}  // namespace brindle
