/// Where a picture is taken from.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "brindle/export.h"
#include "brindle/mesh.h"

namespace BRINDLE_EXPORT brindle {

enum class UpAxis { y, z };

/// How depth is seen.
enum class Projection {
  perspective,
  orthographic  ///< parallel: what is equally long looks equally long, however far away
};

/// A plane that opens surfaces: what lies on the side that its normal points to is not seen.
struct Slice {
  Eigen::Vector3d point = Eigen::Vector3d::Zero();    ///< of the plane
  Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();  ///< of any length above 0
  /// The point is in shares of the bounding box of the points that are framed, 0 to 1 along each
  /// axis, and not in their coordinates.
  bool in_shares = false;

  bool operator==(const Slice&) const = default;
};

/// The side from which a mesh is looked at; distance and aim follow from its shape. With y up,
/// azimuth and elevation 0 look from +z towards -z, with +x to the right; with z up, from -y
/// towards +y, with +x to the right. The camera moves counter-clockwise, seen from above, as
/// azimuth grows.
struct CameraView {
  float azimuth_deg = 30;
  float elevation_deg = 20;  ///< -90 (from below) to 90 (from above)
  float zoom = 1;            ///< 1: the whole mesh fills the picture; 2: its middle, twice as large
  UpAxis up = UpAxis::y;
  Projection projection = Projection::perspective;
  /// What is in the middle of the picture, in the coordinates of the points that are framed.
  /// Without it the picture is filled by them, as `framed_camera` says.
  std::optional<Vec3> center = {};
  /// Turns the points' coordinates to the viewer's: x to the right, y up, z towards the viewer.
  /// Instead of azimuth, elevation and `up`, which have no say then; need not be of unit length.
  std::optional<Eigen::Quaternionf> rotation = {};
  /// In the coordinates of the points that are framed. It has no say in how they are framed.
  std::optional<Slice> slice = {};

  bool operator==(const CameraView&) const = default;
};

/// Where the brightest light of a picture comes from, seen from the camera: 0,0 is the viewer,
/// azimuth 90 is at the viewer's right and -90 at the left, elevation 90 is above. Angles may be
/// any finite numbers: light may come from behind what is seen.
struct LightDirection {
  float azimuth_deg = 0;
  float elevation_deg = 0;

  bool operator==(const LightDirection&) const = default;
};

/// The light of a picture: the sky is where `up` points; without a direction, the brightest light
/// comes from the upper left, about -31,39.
struct PictureLight {
  UpAxis up = UpAxis::y;
  std::optional<LightDirection> from = {};
};

/// The rotation of a view, whichever way it is given: where a free rotation starts from.
Eigen::Quaternionf rotation_of(const CameraView& view);

/// A camera. World coordinates are taken relative to `origin`, which is near the mesh,
/// so that a mesh far from zero keeps its digits.
struct Camera {
  Vec3 origin = Vec3::Zero();
  Eigen::Matrix4f view_from_world = Eigen::Matrix4f::Identity();  ///< of points less `origin`
  Eigen::Matrix4f clip_from_view = Eigen::Matrix4f::Identity();   ///< OpenGL's clip space

  /// What is on its positive side is not seen; in the coordinates of the points that are framed.
  std::optional<Eigen::Hyperplane<float, 3>> slice = {};

  /// Whether the slice takes the point away.
  bool cuts_off(const Vec3& point) const { return slice && slice->signedDistance(point) > 0; }

  bool orthographic() const { return clip_from_view(3, 3) == 1; }
};

/// Where the camera stands, in the coordinates of the points that it frames.
Vec3 eye_of(const Camera& camera);

/// Where lines of sight come from, for `silhouette_lines`: the eye, or in parallel projection a
/// point so far away that they are parallel.
Vec3 viewpoint_of(const Camera& camera);

/// The positions of all vertices that a triangle uses, each once.
std::vector<Vec3> points_of_triangles(const Mesh& mesh);

/// The camera whose picture of `width` x `height` pixels the points fill up to a small margin: the
/// closest one from which none is cut off. No points count as one at zero. With a centre, the same
/// camera moved sideways so that the centre is in the middle.
Camera framed_camera(std::span<const Vec3> points, const CameraView& view, int width, int height);

}  // namespace brindle
