#include "session/picking.h"

#include <array>
#include <cmath>
#include <limits>
#include <mutex>
#include <span>

#include <Eigen/Geometry>

#include "brindle/base/array_numbers.h"
#include "brindle/base/parallel.h"
#include "brindle/base/text.h"
#include "brindle/fragment_phase.h"

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

/// The numbers of an array with one row.
std::string text_of_row(const DataArray& row) {
  std::string text;
  for_each_number(row.view(), [&](std::size_t, std::size_t, auto number) {
    text += (text.empty() ? "" : ", ") + formatted("%.5g", static_cast<double>(number));
  });
  return text;
}

void add_wave(const StripePattern& pattern, const Triangle& triangle, const Vec3& barycentric,
              std::vector<PickedValue>& values) {
  const FragmentWave wave =
      fragment_phase(corner_waves(triangle, pattern.waves, pattern.solution.z), barycentric);
  if (wave.z == Complex(0)) {
    values.push_back({"wave", "none"});
    return;
  }
  // In either direction, 1 is the middle of a stripe and -1 that of a gap.
  values.push_back({"sine of the phase", formatted("%.2f", static_cast<double>(wave.z.imag()))});
  values.push_back({"frequency", formatted("%.5g", static_cast<double>(wave.frequency))});
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

std::vector<PickedValue> values_at(const LiveState& state, const PickedPoint& point) {
  const StripeJob& job = *state.job;
  const Triangle& triangle = job.surface->mesh.triangles[point.triangle];
  std::vector<PickedValue> values = {
      {"place", formatted("%.5g, %.5g, %.5g", point.place.x(), point.place.y(), point.place.z())}};
  add_wave(job.result.stripes(), triangle, point.barycentric, values);
  const Eigen::Vector3d weights = point.barycentric.cast<double>();
  const RowBlend corners{triangle, {weights[0], weights[1], weights[2]}};
  for (const DataArray& array : job.data.arrays.points) {
    if (array.rows() != job.surface->mesh.vertex_count()) continue;
    values.push_back({shown(array.name), text_of_row(blended(array, std::span(&corners, 1)))});
  }
  const auto number = static_cast<Index>(point.triangle);
  for (const DataArray& array : job.data.arrays.cells) {
    if (array.rows() != job.surface->mesh.triangle_count()) continue;
    values.push_back({shown(array.name), text_of_row(rows_of(array, std::span(&number, 1)))});
  }
  return values;
}

}  // namespace brindle::tool
