/// Implicit functions that items of the gallery are made of. All are negative inside and nowhere
/// steeper than 1, as `isosurface` wants them.
#pragma once

#include <vector>

#include <Eigen/Core>

#include "brindle/shapes/isosurface.h"

namespace brindle {

/// An ellipsoid in the box of half sizes `radii`, its axes turned by `turn`. It has the right sign,
/// and a value that is smaller than the distance.
ImplicitFunction ellipsoid(const Eigen::Vector3d& center, const Eigen::Vector3d& radii,
                           const Eigen::Matrix3d& turn = Eigen::Matrix3d::Identity());

/// A segment with round ends, its radius changing linearly.
ImplicitFunction limb(const Eigen::Vector3d& from, const Eigen::Vector3d& to, double radius_from,
                      double radius_to);

ImplicitFunction ball(const Eigen::Vector3d& center, double radius);

/// All of them, with blends of about radius `blend` above 0.
ImplicitFunction blended(std::vector<ImplicitFunction> parts, double blend);

/// What is inside of both, the edge between them rounded by about `blend`.
ImplicitFunction common(ImplicitFunction a, ImplicitFunction b, double blend);
/// The first without the second.
ImplicitFunction without(ImplicitFunction a, ImplicitFunction b, double blend);

/// A rotation about x, then y, then z, in degrees.
Eigen::Matrix3d turned(double x_deg, double y_deg, double z_deg);

/// Principal curvatures of the level set through a point, positive where it bends away from the
/// gradient, and the direction of the larger one.
struct LevelCurvature {
  double larger = 0, smaller = 0;
  Eigen::Vector3d larger_direction, smaller_direction, normal;
};

/// From differences of the function over `step`, a length over which curvatures are averaged.
LevelCurvature level_curvature(const ImplicitFunction& function, const Eigen::Vector3d& at,
                               double step);

/// So many evaluations of them per vertex that reports come more often than elsewhere.
constexpr std::size_t kFunctionSlice = 1 << 10;

/// Moves vertices that are near to the surface onto it, by Newton's steps; slopes are differences
/// over `step`.
void settle(Mesh& mesh, const ImplicitFunction& function, double step,
            const Progress& progress = {});

/// Opens a closed mesh at a plane: drops what is beyond, where (p - point) * normal is above 0. The
/// rim lies in the plane. Within `reach` of the point alone.
void cut_open(Mesh& mesh, const Eigen::Vector3d& point, const Eigen::Vector3d& normal,
              double reach);

}  // namespace brindle
