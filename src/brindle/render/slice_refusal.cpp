#include "brindle/render/slice_refusal.h"

#include "brindle/base/standard.h"
#include "brindle/base/text.h"
#include "brindle/error.h"

namespace brindle {
namespace {

/// A mesh, and the offset of its origin from the camera's.
struct CutMesh {
  const Mesh& mesh;
  Vec3 offset = Vec3::Zero();
};

/// Whether any area remains. Contact with the plane in a point or a line has no area; triangles
/// within the plane are kept.
bool is_left(const CutMesh& cut, const Camera& camera) {
  const Mesh& mesh = cut.mesh;
  const auto height = [&](Index v) {
    return camera.slice->signedDistance(mesh.positions[v] + cut.offset);
  };
  // Positions in percent of a box are rounded.
  const float near = 1e-6f * bounding_box(mesh).diagonal();
  if (mesh.triangles.empty()) {
    return ranges::any_of(mesh.positions, [&](const Vec3& point) {
      return camera.slice->signedDistance(point + cut.offset) <= near;
    });
  }
  return ranges::any_of(mesh.triangles, [&](const Triangle& triangle) {
    const Vec3 heights(height(triangle[0]), height(triangle[1]), height(triangle[2]));
    return heights.minCoeff() < -near || heights.cwiseAbs().maxCoeff() <= near;
  });
}

void extend(BoundingBox& box, const CutMesh& cut) {
  const BoundingBox own = bounding_box(cut.mesh);
  box.lower = box.lower.cwiseMin(own.lower + cut.offset);
  box.upper = box.upper.cwiseMax(own.upper + cut.offset);
}

std::string refusal(const BoundingBox& box, const Eigen::Vector3d& origin,
                    const std::string& name) {
  std::string ranges;
  for (int axis = 0; axis < 3; ++axis) {
    ranges += formatted("%s %c from %.4g to %.4g", axis == 0 ? "" : ",", 'x' + axis,
                        origin[axis] + static_cast<double>(box.lower[axis]),
                        origin[axis] + static_cast<double>(box.upper[axis]));
  }
  return name + " leaves nothing of the surface, which has" + ranges +
         "; put the plane elsewhere, or take the other side, such as -x=50%";
}

}  // namespace

std::string slice_refusal(const Mesh& mesh, const Camera& camera, const std::string& name) {
  if (!camera.slice || mesh.positions.empty() || is_left({mesh}, camera)) return "";
  return refusal(bounding_box(mesh), mesh.origin, name);
}

std::string slice_refusal(std::span<const StyledSurface> surfaces, const Camera& camera,
                          const std::string& name) {
  if (!camera.slice || surfaces.empty()) return "";
  const Eigen::Vector3d& origin = surfaces.front().mesh.origin;
  BoundingBox box = bounding_box(surfaces.front().mesh);
  for (const StyledSurface& surface : surfaces) {
    const CutMesh cut{surface.mesh, (surface.mesh.origin - origin).cast<float>()};
    if (surface.sliced ? is_left(cut, camera) : !surface.mesh.triangles.empty()) return "";
    extend(box, cut);
  }
  return refusal(box, origin, name);
}

void check_slice(const std::string& refusal) {
  if (!refusal.empty()) throw Error(refusal);
}

void check_slice(const Mesh& mesh, const RenderOptions& render, const std::string& name) {
  if (!render.camera.slice) return;
  const std::vector<Vec3> points =
      mesh.triangles.empty() ? mesh.positions : points_of_triangles(mesh);
  check_slice(
      slice_refusal(mesh, framed_camera(points, render.camera, render.width, render.height), name));
}

}  // namespace brindle
