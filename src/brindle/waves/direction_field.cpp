#include "brindle/direction_field.h"

#include <cmath>
#include <vector>

#include <Eigen/Geometry>

#include "brindle/base/elementary.h"
#include "brindle/base/parallel.h"
#include "brindle/error.h"

namespace brindle {
namespace {

/// A vector closer to the normal than this (as a sine) has no direction in the tangent plane.
constexpr float kParallelToNormal = 1e-4f;

}  // namespace

Vec3 tangent_direction(const Vec3& vector, const Vec3& normal) {
  float length = vector.norm();
  // Squares may be out of the range of float although the vector is not.
  if (!(length > 0) || !std::isfinite(length)) length = vector.stableNorm();
  if (!(length > 0) || !std::isfinite(length) || normal.isZero(0)) return Vec3::Zero();
  const Vec3 unit = vector / length;
  const Vec3 tangent = unit - unit.dot(normal) * normal;
  const float sine = tangent.norm();
  if (!(sine > kParallelToNormal)) return Vec3::Zero();
  return tangent / sine;
}

DirectionField tangent_directions(std::span<const Vec3> vectors, std::span<const Vec3> normals) {
  DirectionField directions(vectors.size());
  parallel_for(vectors.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      directions[i] = tangent_direction(vectors[i], normals[i]);
    }
  });
  return directions;
}

DirectionField projected_direction_field(const Vec3& axis, std::span<const Vec3> normals) {
  if (!axis.allFinite() || axis.isZero(0)) {
    throw Error("the direction must be a finite vector other than 0,0,0");
  }
  return tangent_directions(std::vector<Vec3>(normals.size(), axis), normals);
}

DirectionField curvature_direction_field(std::span<const PrincipalCurvature> curvatures,
                                         CurvatureDirection direction) {
  DirectionField directions(curvatures.size());
  for (std::size_t i = 0; i < curvatures.size(); ++i) {
    directions[i] = direction == CurvatureDirection::maximum ? curvatures[i].maximum_direction
                                                             : curvatures[i].minimum_direction;
  }
  return directions;
}

DirectionField rotated(std::span<const Vec3> directions, std::span<const Vec3> normals,
                       float radians) {
  const float cosine = elementary::cos(radians), sine = elementary::sin(radians);
  DirectionField turned(directions.size());
  for (std::size_t i = 0; i < directions.size(); ++i) {
    turned[i] = cosine * directions[i] + sine * normals[i].cross(directions[i]);
  }
  return turned;
}

}  // namespace brindle
