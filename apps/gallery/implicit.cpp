#include "gallery/implicit.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

#include "brindle/base/elementary.h"
#include "brindle/base/parallel.h"
#include "brindle/shapes/capsules.h"

namespace brindle {
namespace {

using Point = Eigen::Vector3d;

/// Smooth minimum: -blend * log(exp(-a / blend) + exp(-b / blend)).
double smooth_minimum(double a, double b, double blend) {
  return std::min(a, b) - blend * elementary::log(1 + elementary::exp(-std::abs(a - b) / blend));
}

}  // namespace

ImplicitFunction ellipsoid(const Point& center, const Point& radii, const Eigen::Matrix3d& turn) {
  const Eigen::Matrix3d to_unit = radii.cwiseInverse().asDiagonal() * turn.transpose();
  const double smallest = radii.minCoeff();
  return [=](const Point& p) { return ((to_unit * (p - center)).norm() - 1) * smallest; };
}

ImplicitFunction limb(const Point& from, const Point& to, double radius_from, double radius_to) {
  return CapsuleDistance({from, to, radius_from, radius_to});
}

ImplicitFunction ball(const Point& center, double radius) {
  return limb(center, center, radius, radius);
}

ImplicitFunction blended(std::vector<ImplicitFunction> parts, double blend) {
  return [parts = std::move(parts), blend](const Point& p) {
    double value = 1e30;
    for (const ImplicitFunction& part : parts) value = smooth_minimum(value, part(p), blend);
    return value;
  };
}

ImplicitFunction common(ImplicitFunction a, ImplicitFunction b, double blend) {
  return [a = std::move(a), b = std::move(b), blend](const Point& p) {
    return -smooth_minimum(-a(p), -b(p), blend);
  };
}

ImplicitFunction without(ImplicitFunction a, ImplicitFunction b, double blend) {
  return common(
      std::move(a), [b = std::move(b)](const Point& p) { return -b(p); }, blend);
}

Eigen::Matrix3d turned(double x_deg, double y_deg, double z_deg) {
  constexpr double kDegree = std::numbers::pi / 180;
  const Eigen::AngleAxisd x(x_deg * kDegree, Point::UnitX()), y(y_deg * kDegree, Point::UnitY()),
      z(z_deg * kDegree, Point::UnitZ());
  return (z * y * x).toRotationMatrix();
}

LevelCurvature level_curvature(const ImplicitFunction& function, const Point& at, double step) {
  const double here = function(at);
  Point gradient;
  Eigen::Matrix3d hessian;
  for (int i = 0; i < 3; ++i) {
    const Point x = step * Point::Unit(i);
    const double after = function(at + x), before = function(at - x);
    gradient[i] = (after - before) / (2 * step);
    hessian(i, i) = (after - 2 * here + before) / (step * step);
    for (int j = 0; j < i; ++j) {
      const Point y = step * Point::Unit(j);
      hessian(i, j) = hessian(j, i) = (function(at + x + y) - function(at + x - y) -
                                       function(at - x + y) + function(at - x - y)) /
                                      (4 * step * step);
    }
  }
  const double slope = gradient.norm();
  LevelCurvature result;
  result.normal = gradient / slope;
  const Point u = result.normal.unitOrthogonal(), v = result.normal.cross(u);
  Eigen::Matrix<double, 3, 2> tangents;
  tangents << u, v;
  const Eigen::Matrix2d shape = tangents.transpose() * hessian * tangents / slope;
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> axes(shape);
  result.smaller = axes.eigenvalues()[0];
  result.larger = axes.eigenvalues()[1];
  result.smaller_direction = tangents * axes.eigenvectors().col(0);
  result.larger_direction = tangents * axes.eigenvectors().col(1);
  return result;
}

void settle(Mesh& mesh, const ImplicitFunction& function, double step, const Progress& progress) {
  constexpr int kSteps = 3;
  parallel_for(
      mesh.vertex_count(), progress,
      [&](std::size_t begin, std::size_t end) {
        for (std::size_t v = begin; v < end; ++v) {
          Point p = mesh.positions[v].cast<double>();
          for (int k = 0; k < kSteps; ++k) {
            const double value = function(p);
            Point slope;
            for (int axis = 0; axis < 3; ++axis) {
              slope[axis] = (function(p + step * Point::Unit(axis)) - value) / step;
            }
            p -= value / std::max(slope.squaredNorm(), 1e-6) * slope;
          }
          mesh.positions[v] = p.cast<float>();
        }
      },
      kParallelGrain, kFunctionSlice);
}

void cut_open(Mesh& mesh, const Point& point, const Point& normal, double reach) {
  const auto beyond = [&](Index v) {
    const Point offset = mesh.positions[v].cast<double>() - point;
    return offset.norm() < reach && offset.dot(normal) > 0;
  };
  std::erase_if(mesh.triangles,
                [&](const Triangle& t) { return beyond(t[0]) && beyond(t[1]) && beyond(t[2]); });
  drop_unreferenced_vertices(mesh);
  for (Index v = 0; v < mesh.vertex_count(); ++v) {
    if (!beyond(v)) continue;
    const Point offset = mesh.positions[v].cast<double>() - point;
    mesh.positions[v] -= (offset.dot(normal) * normal).cast<float>();
  }
}

}  // namespace brindle
