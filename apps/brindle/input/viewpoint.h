/// Where a picture is taken from, before there is one.
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include <CLI/CLI.hpp>

#include "brindle/camera.h"

namespace brindle::tool {

struct Viewpoint {
  CameraView view;                            ///< its slice is in the coordinates of files
  int width = 0;                              ///< of the picture, pixels
  int height = 0;                             ///< of the picture, pixels
  std::optional<Mesh> framed = std::nullopt;  ///< by the camera, instead of the surface itself
  UpAxis height_axis = UpAxis::z;             ///< what heights are measured along
  std::optional<LightDirection> light_from = std::nullopt;  ///< of the picture
};

/// The camera of this viewpoint, relative to the origin of `mesh`; of meshes without triangles, all
/// vertices are framed.
Camera camera_of(const Viewpoint& viewpoint, const Mesh& mesh);

/// Whether the command draws pictures from a viewpoint.
bool has_camera(const CLI::App& command);

}  // namespace brindle::tool
