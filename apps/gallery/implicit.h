/// Implicit functions for items of the gallery. All are negative inside and have slopes of at most
/// 1, as `isosurface` requires.
#pragma once

#include <vector>

#include <Eigen/Core>

#include "brindle/shapes/isosurface.h"

namespace brindle {

/// An ellipsoid with half axes `radii`, rotated by `turn`. The value has the right sign and is less
/// than the distance.
ImplicitFunction ellipsoid(const Eigen::Vector3d& center, const Eigen::Vector3d& radii,
                           const Eigen::Matrix3d& turn = Eigen::Matrix3d::Identity());

/// A segment with round ends and linearly varying radius.
ImplicitFunction limb(const Eigen::Vector3d& from, const Eigen::Vector3d& to, double radius_from,
                      double radius_to);

ImplicitFunction ball(const Eigen::Vector3d& center, double radius);

/// Their union, with blends of about radius `blend` above 0.
ImplicitFunction blended(std::vector<ImplicitFunction> parts, double blend);

/// The intersection, with edges rounded by about `blend`.
ImplicitFunction common(ImplicitFunction a, ImplicitFunction b, double blend);
/// The difference.
ImplicitFunction without(ImplicitFunction a, ImplicitFunction b, double blend);

/// A rotation about x, then y, then z, in degrees.
Eigen::Matrix3d turned(double x_deg, double y_deg, double z_deg);

/// Principal curvatures of the level set through a point, positive if it bends away from the
/// gradient, and the direction of the larger one.
struct LevelCurvature {
  double larger = 0, smaller = 0;
  Eigen::Vector3d larger_direction, smaller_direction, normal;
};

/// By finite differences over `step`, the averaging length.
LevelCurvature level_curvature(const ImplicitFunction& function, const Eigen::Vector3d& at,
                               double step);

/// Evaluations are slow, so reports come after fewer vertices than elsewhere.
constexpr std::size_t kFunctionSlice = 1 << 10;

/// Projects nearby vertices to the surface by Newton's method; slopes are finite differences over
/// `step`.
void settle(Mesh& mesh, const ImplicitFunction& function, double step,
            const Progress& progress = {});

/// Cuts a closed mesh open at a plane, within `reach` of the point: removes the part where (p -
/// point) * normal is above 0. The rim is in the plane.
void cut_open(Mesh& mesh, const Eigen::Vector3d& point, const Eigen::Vector3d& normal,
              double reach);

}  // namespace brindle
