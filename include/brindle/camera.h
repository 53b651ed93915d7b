/// Cameras and lights of pictures.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "brindle/export.h"
#include "brindle/mesh.h"

namespace BRINDLE_EXPORT brindle {

/// The axis that points up; `minus_z` is -z, as in a file that was made upside down.
enum class UpAxis { x, y, z, minus_x, minus_y, minus_z };

/// The coordinate axes of a picture at azimuth and elevation 0, as rows: to the right, up and
/// towards the viewer.
Eigen::Matrix3f upright_axes(UpAxis up);

/// Projections of the camera.
enum class Projection {
  perspective,
  orthographic  ///< parallel: equal lengths look equal at any distance
};

/// A clipping plane: nothing is drawn on the side that its normal points to.
struct Slice {
  Eigen::Vector3d point = Eigen::Vector3d::Zero();    ///< of the plane
  Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();  ///< of any length above 0
  /// `point` is in shares of the bounding box of the framed points, 0 to 1 along each axis, rather
  /// than in their coordinates.
  bool in_shares = false;

  bool operator==(const Slice&) const = default;
};

/// The direction of view; distance and target follow from the shape. At azimuth and elevation 0,
/// with y up, it is from +z towards -z; with z up, from -y towards +y; +x is to the right, with x
/// up, -y is (`upright_axes`). As azimuth grows, the camera moves counter-clockwise, seen from
/// above.
struct CameraView {
  float azimuth_deg = 30;
  float elevation_deg = 20;  ///< -90 (from below) to 90 (from above)
  float zoom = 1;            ///< 1: the whole mesh fills the picture; 2: its middle, twice as large
  UpAxis up = UpAxis::y;
  Projection projection = Projection::perspective;
  /// The middle of the picture, in the coordinates of the framed points. Empty: the points fill the
  /// picture, as in `framed_camera`.
  std::optional<Vec3> center = {};
  /// Rotates the points' coordinates to the viewer's: x to the right, y up, z towards the viewer.
  /// Replaces azimuth, elevation and `up`. Need not be of unit length.
  std::optional<Eigen::Quaternionf> rotation = {};
  /// In the coordinates of the framed points. It does not affect the framing.
  std::optional<Slice> slice = {};
  /// Orthographic: the height of the picture at zoom 1, in the units of the points. Empty: the
  /// points fill the picture.
  std::optional<float> visible_height = {};

  bool operator==(const CameraView&) const = default;
};

/// The direction of the brightest light, seen from the camera: 0,0 is the viewer, azimuth 90 is at
/// the viewer's right and -90 at the left, elevation 90 is above. Angles may be any finite numbers;
/// light may come from behind the object.
struct LightDirection {
  float azimuth_deg = 0;
  float elevation_deg = 0;

  bool operator==(const LightDirection&) const = default;
};

/// The light of a picture: the sky is in the direction of `up`. Without a direction, the brightest
/// light comes from the upper left, about -31,39.
struct PictureLight {
  UpAxis up = UpAxis::y;
  std::optional<LightDirection> from = {};
};

/// The rotation of a view, from its angles or its free rotation.
Eigen::Quaternionf rotation_of(const CameraView& view);

/// A camera. World coordinates are relative to `origin`, a point near the mesh, so that a mesh far
/// from zero keeps its precision.
struct Camera {
  Vec3 origin = Vec3::Zero();
  /// Applies to points minus `origin`.
  Eigen::Matrix4f view_from_world = Eigen::Matrix4f::Identity();
  Eigen::Matrix4f clip_from_view = Eigen::Matrix4f::Identity();  ///< to OpenGL's clip space

  /// Nothing is drawn on its positive side. In the coordinates of the framed points.
  std::optional<Eigen::Hyperplane<float, 3>> slice = {};

  /// Whether the slice removes the point.
  bool cuts_off(const Vec3& point) const { return slice && slice->signedDistance(point) > 0; }

  bool orthographic() const { return clip_from_view(3, 3) == 1; }
};

/// The position of the camera, in the coordinates of the framed points.
Vec3 eye_of(const Camera& camera);

/// The viewpoint for `silhouette_lines`: the eye or, in parallel projection, a point so far away
/// that lines of sight are parallel.
Vec3 viewpoint_of(const Camera& camera);

/// The positions of all vertices that a triangle uses, each once.
std::vector<Vec3> points_of_triangles(const Mesh& mesh);

/// The closest camera that shows all points, with a small margin, in a picture of `width` x
/// `height` pixels. No points count as one at zero. With a centre, the camera is moved sideways
/// until the centre is in the middle. Throws Error for a visible height in perspective, or if it
/// leaves no space for all points at zoom 1 without a centre.
Camera framed_camera(std::span<const Vec3> points, const CameraView& view, int width, int height);

}  // namespace brindle
