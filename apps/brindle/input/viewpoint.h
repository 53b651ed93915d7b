/// The viewpoint of a future picture.
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include <CLI/CLI.hpp>

#include "brindle/camera.h"

namespace brindle::tool {

struct Viewpoint {
  CameraView view;                            ///< with the slice in file coordinates
  int width = 0;                              ///< of the picture, pixels
  int height = 0;                             ///< of the picture, pixels
  std::optional<Mesh> framed = std::nullopt;  ///< framed by the camera, instead of the surface
  UpAxis height_axis = UpAxis::z;             ///< the axis of heights
  std::optional<LightDirection> light_from = std::nullopt;  ///< of the picture
};

/// The camera of this viewpoint, relative to the origin of `mesh`. It frames all vertices of meshes
/// without triangles.
Camera camera_of(const Viewpoint& viewpoint, const Mesh& mesh);

/// Whether the command draws pictures from a viewpoint.
bool has_camera(const CLI::App& command);

}  // namespace brindle::tool
