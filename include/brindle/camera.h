/// Where a picture is taken from.
#pragma once

#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include <Eigen/Core>

#include "brindle/export.h"
#include "brindle/mesh.h"

namespace BRINDLE_EXPORT brindle {

enum class UpAxis { y, z };

/// The side from which a mesh is looked at; distance and aim follow from its shape. With y up,
/// azimuth and elevation 0 look from +z towards -z, with +x to the right; with z up, from -y
/// towards +y, with +x to the right. The camera moves counter-clockwise, seen from above, as
/// azimuth grows.
struct CameraView {
  float azimuth_deg = 30;
  float elevation_deg = 20;  ///< -90 (from below) to 90 (from above)
  float zoom = 1;            ///< 1: the whole mesh fills the picture; 2: its middle, twice as large
  UpAxis up = UpAxis::y;
};

/// Reads "azimuth,elevation" or "azimuth,elevation,zoom", in degrees, into a view with `up`.
/// Empty if the text is not that, a number is not finite, elevation is beyond -90 .. 90 or zoom is
/// not in 0.01 .. 10000.
std::optional<CameraView> parse_camera_view(std::string_view text, UpAxis up = UpAxis::y);

/// A perspective camera. World coordinates are taken relative to `origin`, which is near the mesh,
/// so that a mesh far from zero keeps its digits.
struct Camera {
  Vec3 origin = Vec3::Zero();
  Eigen::Matrix4f view_from_world = Eigen::Matrix4f::Identity();  ///< of points less `origin`
  Eigen::Matrix4f clip_from_view = Eigen::Matrix4f::Identity();   ///< OpenGL's clip space
};

/// The positions of all vertices that a triangle uses, each once.
std::vector<Vec3> points_of_triangles(const Mesh& mesh);

/// The camera whose picture of `width` x `height` pixels the points fill up to a small margin: the
/// closest one from which none is cut off. No points count as one at zero.
Camera framed_camera(std::span<const Vec3> points, const CameraView& view, int width, int height);

}  // namespace brindle
