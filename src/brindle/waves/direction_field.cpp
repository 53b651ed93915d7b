#include "brindle/direction_field.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include <Eigen/Geometry>

#include "brindle/base/elementary.h"
#include "brindle/base/parallel.h"
#include "brindle/base/standard.h"
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

namespace {

/// The cosine of N times the angle between two vectors: Chebyshev's polynomial of its cosine.
float cosine_of_multiple(const Vec3& a, const Vec3& b, int symmetry) {
  const float lengths = std::sqrt(a.squaredNorm() * b.squaredNorm());
  const float cosine = lengths > 0 ? a.dot(b) / lengths : 1;
  float last = 1, now = cosine;
  for (int n = 1; n < symmetry; ++n) {
    const float next = 2 * cosine * now - last;
    last = now;
    now = next;
  }
  return now;
}

/// The angle from one vector to another about a unit normal.
float angle_between(const Vec3& from, const Vec3& to, const Vec3& normal) {
  return elementary::atan2(normal.dot(from.cross(to)), from.dot(to));
}

}  // namespace

int field_index(const Vec3& normal, const std::array<Vec3, 3>& directions, int symmetry) {
  const Vec3 n = normal.stableNormalized();
  std::array<Vec3, 3> flat;
  for (int m = 0; m < 3; ++m) flat[m] = directions[m] - directions[m].dot(n) * n;
  // Three angles add up to a whole turn only if one is at least a third of it.
  const auto is_small = [&](int m) {
    return cosine_of_multiple(flat[m], flat[(m + 1) % 3], symmetry) > 0;
  };
  if (is_small(0) && is_small(1) && is_small(2)) return 0;
  const float turn = 2 * std::numbers::pi_v<float> / static_cast<float>(symmetry);
  float sum = 0;
  for (int m = 0; m < 3; ++m) {
    sum += std::remainder(angle_between(flat[m], flat[(m + 1) % 3], n), turn);
  }
  return static_cast<int>(std::lround(sum / turn));
}

namespace {

/// The index of a triangle; 0 if a corner has no direction.
int index_of(const Mesh& mesh, std::size_t triangle, std::span<const Vec3> directions,
             int symmetry) {
  const Triangle& corners = mesh.triangles[triangle];
  const std::array<Vec3, 3> d = {directions[corners[0]], directions[corners[1]],
                                 directions[corners[2]]};
  if (ranges::any_of(d, [](const Vec3& v) { return v.isZero(0); })) return 0;
  const Vec3& a = mesh.positions[corners[0]];
  const Vec3 normal = (mesh.positions[corners[1]] - a).cross(mesh.positions[corners[2]] - a);
  return field_index(normal, d, symmetry);
}

}  // namespace

std::vector<SingularTriangle> singular_triangles(const Mesh& mesh, std::span<const Vec3> directions,
                                                 int symmetry) {
  std::vector<int> indices(mesh.triangle_count());
  parallel_for(indices.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t t = begin; t < end; ++t) indices[t] = index_of(mesh, t, directions, symmetry);
  });
  std::vector<SingularTriangle> singular;
  for (Index t = 0; t < indices.size(); ++t) {
    if (indices[t] != 0) singular.push_back({t, indices[t]});
  }
  return singular;
}

std::size_t count_singularities(const Mesh& mesh, std::span<const Vec3> directions, int symmetry) {
  return parallel_sum<std::size_t>(mesh.triangle_count(), [&](std::size_t begin, std::size_t end) {
    std::size_t count = 0;
    for (std::size_t t = begin; t < end; ++t) {
      count += index_of(mesh, t, directions, symmetry) != 0 ? 1 : 0;
    }
    return count;
  });
}

}  // namespace brindle
