/// Point clouds from files.
#pragma once

#include <filesystem>

#include "brindle/surface/point_cloud.h"

namespace brindle {

/// Whether a file holds points and no faces: .csv, and .ply and .obj without faces. False for what
/// cannot be read: `read_mesh` will say why.
bool is_point_file(const std::filesystem::path& path);

/// Reads points, and normals if there are as many, from
/// - CSV: rows of x,y,z or x,y,z,nx,ny,nz (`read_csv`);
/// - PLY and OBJ: the vertices, whether or not there are faces;
/// - any other mesh file: the vertices, without normals.
/// Throws Error naming the file, the line where there is one, and the remedy for a file that cannot
/// be read or has no point with finite coordinates.
LoadedPoints read_points(const std::filesystem::path& path);

}  // namespace brindle
