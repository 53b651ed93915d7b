#include "brindle/camera.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include <Eigen/Geometry>

#include "brindle/base/elementary.h"
#include "brindle/base/file_names.h"
#include "brindle/base/number_text.h"
#include "brindle/base/standard.h"
#include "brindle/base/text.h"
#include "brindle/error.h"
#include "brindle/render/parsed_words.h"

namespace brindle {
namespace {

constexpr double kFieldOfViewDeg = 28;  ///< of the longer side: calm perspective
constexpr double kMargin = 0.05;        ///< of half a side, left free on either side
constexpr std::array<std::string_view, 6> kUpAxes = {"x", "y", "z", "-x", "-y", "-z"};

double radians(double degrees) { return degrees * std::numbers::pi / 180; }

/// Rows: right, up, backwards (towards the viewer).
Eigen::Matrix3d camera_axes(const CameraView& view) {
  if (view.rotation) return view.rotation->cast<double>().normalized().toRotationMatrix();
  const double azimuth = radians(view.azimuth_deg);
  const double elevation = radians(view.elevation_deg);
  const double s = elementary::sin(azimuth);
  const double c = elementary::cos(azimuth);
  Eigen::Matrix3d axes;
  axes.row(0) << c, 0, -s;
  axes.row(2) << s * elementary::cos(elevation), elementary::sin(elevation),
      c * elementary::cos(elevation);
  axes.row(1) = axes.row(2).cross(axes.row(0));
  if (view.up == UpAxis::y) return axes;
  return axes * upright_axes(view.up).cast<double>();
}

/// The largest values of x + t z, -x + t z, y + u z and -y + u z over all vertices, and the range
/// of z: the planes of a viewing pyramid touch the mesh there.
struct Extent {
  static constexpr double kNone = -std::numeric_limits<double>::infinity();
  double right = kNone, left = kNone, top = kNone, bottom = kNone, front = kNone, back = kNone;
};

Extent extent_of(std::span<const Vec3> points, const Vec3& origin, const Eigen::Matrix3d& axes,
                 double t, double u) {
  if (points.empty()) return {0, 0, 0, 0, 0, 0};
  Extent extent;
  for (const Vec3& point : points) {
    const Eigen::Vector3d p = axes * (point - origin).cast<double>();
    extent.right = std::max(extent.right, p.x() + t * p.z());
    extent.left = std::max(extent.left, -p.x() + t * p.z());
    extent.top = std::max(extent.top, p.y() + u * p.z());
    extent.bottom = std::max(extent.bottom, -p.y() + u * p.z());
    extent.front = std::max(extent.front, p.z());
    extent.back = std::max(extent.back, -p.z());
  }
  return extent;
}

/// Around zero if there are no points.
Eigen::AlignedBox3f box_around(std::span<const Vec3> points) {
  Eigen::AlignedBox3f box;
  for (const Vec3& point : points) box.extend(point);
  return box.isEmpty() ? Eigen::AlignedBox3f(Vec3::Zero()) : box;
}

Vec3 middle_of(std::span<const Vec3> points) {
  const Eigen::AlignedBox3f box = box_around(points);
  return box.min() + (box.max() - box.min()) / 2;
}

Eigen::Hyperplane<float, 3> plane_of(const Slice& slice, std::span<const Vec3> points) {
  const Eigen::AlignedBox3d box = box_around(points).cast<double>();
  const Eigen::Vector3d point =
      slice.in_shares ? Eigen::Vector3d(box.min() + slice.point.cwiseProduct(box.sizes()))
                      : slice.point;
  const Eigen::Hyperplane<double, 3> plane(slice.normal.stableNormalized(), point);
  return plane.cast<float>();
}

Eigen::Matrix4f perspective(double t, double u, double near_plane, double far_plane) {
  Eigen::Matrix4d m = Eigen::Matrix4d::Zero();
  m(0, 0) = 1 / t;
  m(1, 1) = 1 / u;
  m(2, 2) = -(far_plane + near_plane) / (far_plane - near_plane);
  m(2, 3) = -2 * far_plane * near_plane / (far_plane - near_plane);
  m(3, 2) = -1;
  return m.cast<float>();
}

/// Half the visible sides.
Eigen::Matrix4f parallel(double half_width, double half_height, double near_plane,
                         double far_plane) {
  Eigen::Matrix4d m = Eigen::Matrix4d::Identity();
  m(0, 0) = 1 / half_width;
  m(1, 1) = 1 / half_height;
  m(2, 2) = -2 / (far_plane - near_plane);
  m(2, 3) = -(far_plane + near_plane) / (far_plane - near_plane);
  return m.cast<float>();
}

/// Half a pixel so large that the picture shows all of the extent, seen straight on.
double half_framed_pixel(const Extent& extent, int width, int height, double size) {
  return std::max({(extent.right + extent.left) / 2 / width,
                   (extent.top + extent.bottom) / 2 / height,
                   1e-3 * size / std::max(width, height)}) /
         (1 - kMargin);
}

void check_visible_height(const Extent& extent, const CameraView& view, int width, int height) {
  if (view.projection != Projection::orthographic) {
    throw Error("a picture in perspective has no scale; take the orthographic projection");
  }
  if (view.zoom != 1 || view.center) return;
  const double visible_height = *view.visible_height;
  const double share = std::max((extent.right + extent.left) / (visible_height * width / height),
                                (extent.top + extent.bottom) / visible_height);
  if (share <= 1 + 1e-6) return;
  throw Error(
      formatted("at this scale the surface is %.2f times as large as the picture; take a "
                "larger picture or a smaller scale",
                std::ceil(100 * share) / 100));
}

/// An orthographic projection of the extent, seen straight on.
Eigen::Matrix4f parallel_projection(const Extent& extent, const CameraView& view, int width,
                                    int height, double size, const Eigen::Vector2d& planes) {
  const double half_pixel =
      (view.visible_height ? static_cast<double>(*view.visible_height) / 2 / height
                           : half_framed_pixel(extent, width, height, size)) /
      static_cast<double>(view.zoom);
  return parallel(half_pixel * width, half_pixel * height, planes[0], planes[1]);
}

/// Finite numbers, separated by commas; empty if the text is anything else.
template <class Number>
std::vector<Number> numbers_in(std::string_view text) {
  std::vector<Number> numbers;
  const char* next = text.data();
  const char* end = text.data() + text.size();
  while (true) {
    Number number = 0;
    const auto [rest, failure] = read_number(next, end, number);
    if (failure != std::errc() || !std::isfinite(number)) return {};
    numbers.push_back(number);
    if (rest == end) break;
    if (*rest != ',') return {};
    next = rest + 1;
  }
  return numbers;
}

}  // namespace

Eigen::Matrix3f upright_axes(UpAxis up) {
  const int number = static_cast<int>(up);
  const float sign = number < 3 ? 1.0f : -1.0f;
  const int axis = number % 3;
  Eigen::Matrix3f axes;
  axes.row(0) = axis == 0 ? Vec3(-sign * Vec3::UnitY()) : Vec3(Vec3::UnitX());
  axes.row(1) = sign * Vec3::Unit(axis);
  axes.row(2) = axes.row(0).cross(axes.row(1));
  return axes;
}

std::optional<UpAxis> parse_up_axis(std::string_view text) {
  const auto name = ranges::find(kUpAxes, text);
  if (name == kUpAxes.end()) return {};
  return static_cast<UpAxis>(name - kUpAxes.begin());
}

std::string_view name_of(UpAxis up) { return kUpAxes[static_cast<std::size_t>(up)]; }

std::optional<UpAxis> usual_up_axis(const std::string& mesh) {
  const bool is_z = mesh.starts_with("shape:") || lower_extension(mesh) == ".stl";
  return is_z ? std::optional(UpAxis::z) : std::nullopt;
}

std::optional<LightDirection> parse_light_direction(std::string_view text) {
  const std::vector<float> numbers = numbers_in<float>(text);
  if (numbers.size() != 2 || std::abs(numbers[1]) > 90) return {};
  return LightDirection{numbers[0], numbers[1]};
}

namespace {

/// "0.2" or "50%" along an axis: "x", or "-x" for the other side.
std::optional<Slice> slice_along(std::string_view name, std::string_view place) {
  const bool backwards = name.starts_with('-');
  if (backwards) name.remove_prefix(1);
  if (name.size() != 1 || name[0] < 'x' || name[0] > 'z') return {};
  Slice slice;
  slice.in_shares = place.ends_with('%');
  if (slice.in_shares) place.remove_suffix(1);
  const std::vector<double> numbers = numbers_in<double>(place);
  if (numbers.size() != 1) return {};
  const int axis = name[0] - 'x';
  slice.point[axis] = numbers[0] / (slice.in_shares ? 100 : 1);
  slice.normal = (backwards ? -1 : 1) * Eigen::Vector3d::Unit(axis);
  return slice;
}

}  // namespace

std::optional<Slice> parse_slice(std::string_view text) {
  const std::size_t equals = text.find('=');
  if (equals != text.npos) return slice_along(text.substr(0, equals), text.substr(equals + 1));
  const std::vector<double> numbers = numbers_in<double>(text);
  if (numbers.size() != 6) return {};
  Slice slice;
  for (int axis = 0; axis < 3; ++axis) {
    slice.point[axis] = numbers[axis];
    slice.normal[axis] = numbers[axis + 3];
  }
  if (slice.normal.isZero(0)) return {};
  return slice;
}

namespace {

/// Azimuth, elevation and, if given, zoom.
std::vector<float> camera_numbers(std::string_view text) {
  const std::size_t comma = text.find(',');
  const auto side = ranges::find(kViewSides, text.substr(0, comma), &ViewSide::name);
  if (side == kViewSides.end()) return numbers_in<float>(text);
  std::vector<float> numbers = {side->azimuth_deg, side->elevation_deg};
  if (comma == text.npos) return numbers;
  const std::vector<float> zoom = numbers_in<float>(text.substr(comma + 1));
  if (zoom.size() != 1) return {};
  numbers.push_back(zoom.front());
  return numbers;
}

}  // namespace

std::optional<CameraView> parse_camera_view(std::string_view text, UpAxis up) {
  const std::vector<float> numbers = camera_numbers(text);
  if (numbers.size() < 2 || numbers.size() > 3 || std::abs(numbers[1]) > 90) return {};
  const float zoom = numbers.size() == 3 ? numbers[2] : 1.0f;
  if (zoom < 0.01f || zoom > 10000) return {};
  return CameraView{numbers[0], numbers[1], zoom, up};
}

std::vector<Vec3> points_of_triangles(const Mesh& mesh) {
  std::vector<bool> used(mesh.vertex_count());
  for (const Triangle& triangle : mesh.triangles) {
    for (const Index vertex : triangle) used[vertex] = true;
  }
  std::vector<Vec3> points;
  for (std::size_t v = 0; v < used.size(); ++v) {
    if (used[v]) points.push_back(mesh.positions[v]);
  }
  return points;
}

Camera framed_camera(std::span<const Vec3> points, const CameraView& view, int width, int height) {
  Camera camera;
  camera.origin = middle_of(points);
  const Eigen::Matrix3d axes = camera_axes(view);
  const double longer_side = std::max(width, height);
  const double t = elementary::tan(radians(kFieldOfViewDeg / 2)) * width / longer_side;
  const double u = elementary::tan(radians(kFieldOfViewDeg / 2)) * height / longer_side;
  const double inner_t = t * (1 - kMargin);
  const double inner_u = u * (1 - kMargin);

  // The eye (x, y, z) sees a vertex if p.x + t p.z <= x + t z and so on for the other three planes.
  const Extent extent = extent_of(points, camera.origin, axes, inner_t, inner_u);
  const double size = std::max(
      {extent.front + extent.back, extent.left + extent.right, extent.top + extent.bottom, 1e-30});
  Eigen::Vector3d eye((extent.right - extent.left) / 2, (extent.top - extent.bottom) / 2, 0);
  eye.z() = std::max({(extent.right + extent.left) / (2 * inner_t),
                      (extent.top + extent.bottom) / (2 * inner_u), extent.front + 0.01 * size});

  const bool orthographic = view.projection == Projection::orthographic;
  Extent straight;
  if (orthographic) {
    straight = extent_of(points, camera.origin, axes, 0, 0);
    eye.head<2>() << (straight.right - straight.left) / 2, (straight.top - straight.bottom) / 2;
  }
  if (view.visible_height) check_visible_height(straight, view, width, height);
  if (view.center) eye.head<2>() = (axes * (*view.center - camera.origin).cast<double>()).head<2>();

  if (view.slice) camera.slice = plane_of(*view.slice, points);
  camera.view_from_world.topLeftCorner<3, 3>() = axes.cast<float>();
  camera.view_from_world.topRightCorner<3, 1>() = -eye.cast<float>();
  const double near_plane = std::max(0.9 * (eye.z() - extent.front), 1e-3 * size);
  const double far_plane = 1.1 * (eye.z() + extent.back) + 1e-3 * size;
  camera.clip_from_view =
      orthographic
          ? parallel_projection(straight, view, width, height, size, {near_plane, far_plane})
          : perspective(t / view.zoom, u / view.zoom, near_plane, far_plane);
  return camera;
}

Eigen::Quaternionf rotation_of(const CameraView& view) {
  if (view.rotation) return view.rotation->normalized();
  return Eigen::Quaterniond(camera_axes(view)).cast<float>();
}

Vec3 eye_of(const Camera& camera) {
  const Eigen::Matrix3f axes = camera.view_from_world.topLeftCorner<3, 3>();
  return camera.origin - axes.transpose() * camera.view_from_world.topRightCorner<3, 1>();
}

Vec3 viewpoint_of(const Camera& camera) {
  if (!camera.orthographic()) return eye_of(camera);
  constexpr float kFar = 1e6f;  // times the camera's distance: as good as infinite in float
  const float distance = camera.view_from_world.topRightCorner<3, 1>().norm();
  return eye_of(camera) +
         kFar * std::max(distance, 1e-30f) * camera.view_from_world.row(2).head<3>().transpose();
}

}  // namespace brindle
