/// Curves of strokes drawn with the mouse.
#pragma once

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

/// The distance of a point from a polyline in the plane.
double distance_to_line(const Eigen::Vector2d& point, std::span<const Eigen::Vector2d> line);

}  // namespace brindle::tool
