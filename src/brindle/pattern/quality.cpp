#include "brindle/quality.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <Eigen/Geometry>

#include "brindle/base/parallel.h"
#include "brindle/geometry/areas.h"
#include "brindle/geometry/normals.h"

namespace brindle {
namespace {

struct TriangleError {
  float angle_deg = -1;
  double spacing = 0;
};

TriangleError triangle_error(const Triangle& triangle, const Mesh& mesh, const WaveSet& waves,
                             const CornerPhases& corners) {
  if (corners.kind != TriangleKind::regular) return {};
  std::array<Vec3, 3> position;
  Vec3 direction = Vec3::Zero();
  float frequency = 0;
  for (int m = 0; m < 3; ++m) {
    position[m] = mesh.positions[triangle[m]];
    direction += corners.sign[m] * waves.directions[triangle[m]];
    frequency += waves.frequencies[triangle[m]] / 3;
  }
  const Vec3 slope = linear_gradient(position, corners.phase);
  // The gradient lies in the triangle; what sticks out of it cannot be followed by any pattern.
  const Vec3 normal = triangle_normal(mesh, triangle);
  direction -= direction.dot(normal) * normal;
  const float angle = std::atan2(slope.cross(direction).norm(), slope.dot(direction));
  const float expected = 2 * std::numbers::pi_v<float> * frequency;
  return {angle * 180 / std::numbers::pi_v<float>,
          std::abs(slope.cast<double>().norm() / expected - 1)};
}

struct Sums {
  std::size_t branches = 0, field_singularities = 0;
  double area = 0, over_5deg = 0, angle = 0, spacing = 0;  ///< of regular triangles

  Sums operator+(const Sums& o) const {
    return {branches + o.branches, field_singularities + o.field_singularities,
            area + o.area,         over_5deg + o.over_5deg,
            angle + o.angle,       spacing + o.spacing};
  }
  void count(TriangleKind kind, const TriangleError& error, double triangle_area) {
    branches += kind == TriangleKind::branch || kind == TriangleKind::field_singularity;
    field_singularities += kind == TriangleKind::field_singularity;
    if (kind != TriangleKind::regular || triangle_area == 0) return;
    area += triangle_area;
    if (error.angle_deg > 5) over_5deg += triangle_area;
    angle += triangle_area * static_cast<double>(error.angle_deg);
    spacing += triangle_area * error.spacing;
  }
};

}  // namespace

Vec3 linear_gradient(const std::array<Vec3, 3>& corner, const std::array<float, 3>& value) {
  const Vec3 normal = (corner[1] - corner[0]).cross(corner[2] - corner[0]);
  const float square = normal.squaredNorm();
  if (!(square > 0)) return Vec3::Zero();
  const Vec3 sum = (value[1] - value[0]) * (corner[0] - corner[2]) +
                   (value[2] - value[0]) * (corner[1] - corner[0]);
  return normal.cross(sum) / square;
}

std::vector<float> angle_errors_deg(const Mesh& mesh, const WaveSet& waves,
                                    std::span<const CornerPhases> corners) {
  std::vector<float> errors(mesh.triangle_count());
  parallel_for(errors.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t t = begin; t < end; ++t) {
      errors[t] = triangle_error(mesh.triangles[t], mesh, waves, corners[t]).angle_deg;
    }
  });
  return errors;
}

std::size_t count_without_wave(std::span<const Vec3> directions) {
  return parallel_sum<std::size_t>(directions.size(), [&](std::size_t begin, std::size_t end) {
    std::size_t count = 0;
    for (std::size_t i = begin; i < end; ++i) count += directions[i].isZero(0);
    return count;
  });
}

PatternQuality measure_quality(const Mesh& mesh, const WaveSet& waves,
                               std::span<const CornerPhases> corners) {
  const Sums sums =
      parallel_sum<Sums>(mesh.triangle_count(), [&](std::size_t begin, std::size_t end) {
        Sums sum;
        for (std::size_t t = begin; t < end; ++t) {
          const Triangle& triangle = mesh.triangles[t];
          sum.count(corners[t].kind, triangle_error(triangle, mesh, waves, corners[t]),
                    static_cast<double>(triangle_area(mesh, triangle)));
        }
        return sum;
      });
  const auto mean = [&](double sum) { return sums.area == 0 ? 0 : sum / sums.area; };
  PatternQuality quality;
  quality.branches = sums.branches;
  quality.field_singularities = sums.field_singularities;
  quality.angle_error_mean_deg = mean(sums.angle);
  quality.angle_error_share_over_5deg = mean(sums.over_5deg);
  quality.spacing_error_mean = mean(sums.spacing);
  quality.vertices_without_wave = count_without_wave(waves.directions);
  return quality;
}

}  // namespace brindle
