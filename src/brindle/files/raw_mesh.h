/// What a mesh file holds, before anything of it is joined or repaired.
#pragma once

#include <string>

#include "brindle/data_arrays.h"
#include "brindle/mesh.h"

namespace brindle {

struct RawMesh {
  Mesh mesh;
  DataArrays arrays = {};     ///< a row per vertex and per triangle
  std::string left_out = {};  ///< lines on what of the file is not here, for the user
  std::string taken = {};     ///< lines on what stands for what the file has, for the user
  /// Of a mesh without triangles, what the file holds instead and what to do, after "path: ".
  std::string why_empty = {};
  /// Of VTK's files: there are cells that are neither points nor lines.
  bool has_faces = false;
  std::string normals = {};  ///< the array of points with the normals; empty if the file names none
};

}  // namespace brindle
