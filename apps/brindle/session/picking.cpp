#include "session/picking.h"

#include <array>
#include <cmath>
#include <limits>
#include <mutex>

#include <Eigen/Geometry>

#include "brindle/base/parallel.h"

namespace brindle::tool {
namespace {

using Eigen::Matrix4d;
using Eigen::Vector2d;
using Eigen::Vector3d;
using Eigen::Vector4d;

/// A camera and a pixel, in double precision.
struct PixelView {
  Vector3d origin;
  Matrix4d view_from_world;
  Matrix4d clip_from_view;
  Vector2d pixel;  ///< in clip space
  std::optional<Eigen::Hyperplane<double, 3>> slice;

  PixelView(const Camera& camera, int width, int height, double x, double y)
      : origin(camera.origin.cast<double>()),
        view_from_world(camera.view_from_world.cast<double>()),
        clip_from_view(camera.clip_from_view.cast<double>()),
        pixel(2 * x / width - 1, 1 - 2 * y / height) {
    if (camera.slice) slice = camera.slice->cast<double>();
  }

  Vector3d in_view(const Vec3& position) const {
    const Vector3d relative = position.cast<double>() - origin;
    return (view_from_world * relative.homogeneous()).head<3>();
  }
  /// Clip space's x, y and w.
  Vector3d in_clip(const Vector3d& view) const {
    const Vector4d clip = clip_from_view * view.homogeneous();
    return {clip.x(), clip.y(), clip.w()};
  }
  /// Clip space's x and y relative to the pixel's ray, times w.
  Vector2d across_ray(const Vector3d& view) const {
    const Vector3d clip = in_clip(view);
    return clip.head<2>() - clip.z() * pixel;
  }
};

struct Hit {
  std::size_t triangle = 0;
  Vector3d barycentric = Vector3d::Zero();
  double depth = std::numeric_limits<double>::infinity();

  bool before(const Hit& other) const {
    return depth < other.depth || (depth == other.depth && triangle < other.triangle);
  }
};

bool is_cut_off(const PixelView& view, const Mesh& mesh, const Hit& hit) {
  if (!view.slice) return false;
  double beyond = 0;
  for (int m = 0; m < 3; ++m) {
    const Vec3& corner = mesh.positions[mesh.triangles[hit.triangle][m]];
    beyond += hit.barycentric[m] * view.slice->signedDistance(corner.cast<double>());
  }
  return beyond > 0;
}

/// The intersection of the pixel's ray with a triangle. The three deciding numbers belong to edges
/// and only change sign between the triangles of an edge. They are those of corners in the plane
/// across the ray, which all triangles of a vertex share, so that no ray passes between them
/// (Woop et al. 2013, Watertight ray/triangle intersection).
std::optional<Hit> hit_of(const PixelView& view, const Mesh& mesh, std::size_t number) {
  const Triangle& triangle = mesh.triangles[number];
  std::array<Vector3d, 3> corner;
  std::array<Vector2d, 3> across;
  for (int m = 0; m < 3; ++m) {
    corner[m] = view.in_view(mesh.positions[triangle[m]]);
    across[m] = view.across_ray(corner[m]);
  }
  const auto side_of = [&](int from, int to) {
    return across[from].x() * across[to].y() - across[from].y() * across[to].x();
  };
  const Vector3d side(side_of(1, 2), side_of(2, 0), side_of(0, 1));
  if (!((side.array() >= 0).all() || (side.array() <= 0).all())) return std::nullopt;
  const double sum = side.sum();
  if (sum == 0) return std::nullopt;
  Hit hit{number, side / sum, 0};
  for (int m = 0; m < 3; ++m) hit.depth -= hit.barycentric[m] * corner[m].z();
  if (!(hit.depth > 0) || is_cut_off(view, mesh, hit)) return std::nullopt;
  return hit;
}

PickedPoint picked(const Hit& hit, const Mesh& mesh, const Camera& camera) {
  const Triangle& t = mesh.triangles[hit.triangle];
  Vector3d position = Vector3d::Zero();
  for (int m = 0; m < 3; ++m) {
    position += hit.barycentric[m] * mesh.positions[t[m]].cast<double>();
  }
  const Vec3& a = mesh.positions[t[0]];
  Vec3 normal = (mesh.positions[t[1]] - a).cross(mesh.positions[t[2]] - a).stableNormalized();
  if (normal.dot(viewpoint_of(camera) - position.cast<float>()) < 0) normal = -normal;
  return {hit.triangle, hit.barycentric.cast<float>(), position.cast<float>(),
          normal,       position + mesh.origin,        static_cast<float>(hit.depth)};
}

}  // namespace

std::optional<PickedPoint> pick(const Surface& surface, const Camera& camera, int width, int height,
                                double x, double y) {
  const PixelView view(camera, width, height, x, y);
  Hit nearest;
  std::mutex mutex;
  parallel_for(surface.mesh.triangle_count(), [&](std::size_t begin, std::size_t end) {
    Hit best;
    for (std::size_t t = begin; t < end; ++t) {
      const std::optional<Hit> hit = hit_of(view, surface.mesh, t);
      if (hit && hit->before(best)) best = *hit;
    }
    const std::lock_guard lock(mutex);
    if (best.before(nearest)) nearest = best;
  });
  if (!std::isfinite(nearest.depth)) return std::nullopt;
  return picked(nearest, surface.mesh, camera);
}

std::optional<Eigen::Vector2d> place_in_picture(const Vec3& position, const Camera& camera,
                                                int width, int height) {
  const PixelView view(camera, width, height, 0, 0);
  const Vector3d seen = view.in_view(position);
  const Vector3d clip = view.in_clip(seen);
  if (!(seen.z() < 0) || !(clip.z() > 0)) return std::nullopt;
  return Eigen::Vector2d((clip.x() / clip.z() + 1) / 2 * width,
                         (1 - clip.y() / clip.z()) / 2 * height);
}

}  // namespace brindle::tool
