/// Curves of strokes drawn with the mouse.
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <vector>

#include <Eigen/Core>

namespace brindle::tool {

using Points = std::vector<Eigen::Vector3d>;

/// The Catmull-Rom spline through these points, with `parts` segments between two of them. Its
/// tangents are parallel to the line between the neighbouring points; the ends count twice.
Points catmull_rom(std::span<const Eigen::Vector3d> controls, int parts);

/// At most `most` of the points, evenly along the list, including the first and the last.
Points thinned(std::span<const Eigen::Vector3d> points, std::size_t most);

/// The place on a surface that is seen at a pixel, if there is one.
using PickPlace = std::function<std::optional<Eigen::Vector3d>(const Eigen::Vector2d& pixel)>;

struct SeenPlace {
  Eigen::Vector2d pixel;
  Eigen::Vector3d place;
};

/// Whether a line between two places leaves the surface: between their pixels there is nothing, or
/// a jump to another part of the surface, nearer or farther away.
bool leaves_surface(SeenPlace from, SeenPlace to, const PickPlace& pick);

/// The pixels on the way from one to another, the last included, at most `step` apart.
std::vector<Eigen::Vector2d> pixels_between(const Eigen::Vector2d& from, const Eigen::Vector2d& to,
                                            double step);

/// The distance of a point from a line through others, in the plane.
double distance_to_line(const Eigen::Vector2d& point, std::span<const Eigen::Vector2d> line);

}  // namespace brindle::tool
