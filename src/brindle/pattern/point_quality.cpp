#include "brindle/pattern/point_quality.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include <Eigen/Dense>

#include "brindle/base/elementary.h"
#include "brindle/base/parallel.h"
#include "brindle/corner_phases.h"

namespace brindle {
namespace {

struct PointSums {
  std::size_t count = 0, over_5deg = 0;
  double angle = 0, spacing = 0;

  PointSums operator+(const PointSums& o) const {
    return {count + o.count, over_5deg + o.over_5deg, angle + o.angle, spacing + o.spacing};
  }
};

CornerWave wave_at(const WaveSet& waves, std::span<const Complex> z, Index i) {
  return {waves.wave(i), z[i]};
}

/// The gradient along the wave's direction and across it, in radians per unit length.
std::optional<Eigen::Vector2d> gradient(const CornerWave& wave, const Vec3& normal,
                                        std::span<const CornerWave> neighbors,
                                        PhaseShiftKind kind) {
  const Vec3 along = wave.wave.direction, across = normal.cross(along);
  Eigen::Matrix2d matrix = Eigen::Matrix2d::Zero();
  Eigen::Vector2d right = Eigen::Vector2d::Zero();
  for (CornerWave neighbor : neighbors) {
    if (neighbor.wave.direction.dot(along) < 0) neighbor = flipped(neighbor);
    const Vec3 edge = neighbor.wave.position - wave.wave.position;
    const Eigen::Vector2d e(edge.dot(along), edge.dot(across));
    if (e.isZero(0)) continue;
    const double weight = 1 / e.squaredNorm();
    matrix += weight * e * e.transpose();
    right += weight * e * static_cast<double>(lifted_step(wave, neighbor, kind));
  }
  const double trace = matrix.trace();
  if (!(matrix.determinant() > 1e-6 * trace * trace)) return std::nullopt;
  return matrix.ldlt().solve(right);
}

}  // namespace

PatternQuality measure_point_quality(const Adjacency& neighborhood, std::span<const Vec3> normals,
                                     const WaveSet& waves, std::span<const Complex> z,
                                     PhaseShiftKind kind, const Progress& progress) {
  const auto sums_of = [&](std::size_t begin, std::size_t end) {
    PointSums sums;
    std::vector<CornerWave> neighbors;
    for (auto i = static_cast<Index>(begin); i < end; ++i) {
      if (waves.directions[i].isZero(0)) continue;
      neighbors.clear();
      for (const Index j : neighborhood.of(i)) {
        if (!waves.directions[j].isZero(0)) neighbors.push_back(wave_at(waves, z, j));
      }
      const auto slope = gradient(wave_at(waves, z, i), normals[i], neighbors, kind);
      if (!slope) continue;
      const double angle =
          std::abs(elementary::atan2(slope->y(), std::abs(slope->x()))) * 180 / std::numbers::pi;
      const double expected = 2 * std::numbers::pi * static_cast<double>(waves.frequencies[i]);
      ++sums.count;
      sums.over_5deg += angle > 5;
      sums.angle += angle;
      sums.spacing += std::abs(slope->norm() / expected - 1);
    }
    return sums;
  };
  const PointSums sums = parallel_sum<PointSums>(neighborhood.node_count(), progress, sums_of);
  const double count = std::max<double>(1, static_cast<double>(sums.count));
  PatternQuality quality;
  quality.angle_error_mean_deg = sums.angle / count;
  quality.angle_error_share_over_5deg = static_cast<double>(sums.over_5deg) / count;
  quality.spacing_error_mean = sums.spacing / count;
  quality.vertices_without_wave = count_without_wave(waves.directions);
  return quality;
}

}  // namespace brindle
