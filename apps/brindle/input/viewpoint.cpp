#include "input/viewpoint.h"

namespace brindle::tool {

Camera camera_of(const Viewpoint& viewpoint, const Mesh& mesh) {
  const Mesh& framed = viewpoint.framed ? *viewpoint.framed : mesh;
  std::vector<Vec3> points =
      framed.triangles.empty() ? framed.positions : points_of_triangles(framed);
  const Vec3 offset = (framed.origin - mesh.origin).cast<float>();
  for (Vec3& point : points) point += offset;
  CameraView view = viewpoint.view;
  if (view.slice && !view.slice->in_shares) view.slice->point -= mesh.origin;
  return framed_camera(points, view, viewpoint.width, viewpoint.height);
}

bool has_camera(const CLI::App& command) {
  return command.get_option_no_throw("--camera") != nullptr;
}

}  // namespace brindle::tool
